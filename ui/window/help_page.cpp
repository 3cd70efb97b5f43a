// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_page.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

using Entries = std::vector<std::pair<QString, QString>>; ///< what is done, and by what

QString tableOf(const QString &title, const Entries &entries)
{
    QString html = QStringLiteral("<h3>%1</h3><table width='100%' cellpadding='3'>").arg(title.toHtmlEscaped());
    for (const auto &[what, how] : entries) {
        html += QStringLiteral("<tr><td>%1</td><td width='45%'>%2</td></tr>")
                    .arg(what.toHtmlEscaped(), how.toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

/// As it reads in the menu, whatever there is to undo.
QString nameOf(const QAction &action)
{
    return action.iconText();
}

void collect(const QMenu &menu, const QString &path, Entries &entries)
{
    for (const QAction *action : menu.actions()) {
        const QString name = path + nameOf(*action);
        if (const QMenu *below = action->menu()) {
            collect(*below, HelpPage::tr("%1: ").arg(name), entries);
            continue;
        }
        QStringList keys;
        for (const QKeySequence &key : action->shortcuts()) {
            keys << key.toString(QKeySequence::NativeText);
        }
        if (!keys.isEmpty()) {
            entries.emplace_back(name, keys.join(HelpPage::tr(" or ")));
        }
    }
}

QString paragraph(const QString &text)
{
    return QStringLiteral("<p>%1</p>").arg(text);
}

/// Not translated: mathematics reads the same everywhere.
QString formulas(const QStringList &lines)
{
    return QStringLiteral("<p style='margin-left:24px'>%1</p>").arg(lines.join(QStringLiteral("<br>")));
}

} // namespace

QString shortcutsText(const QMenuBar &menus)
{
    QString html;
    for (const QAction *action : menus.actions()) {
        Entries entries;
        if (const QMenu *menu = action->menu()) {
            collect(*menu, QString(), entries);
        }
        if (!entries.empty()) {
            html += tableOf(nameOf(*action), entries);
        }
    }
    html += tableOf(HelpPage::tr("Everywhere"),
                    {{HelpPage::tr("To the next control, to the one before"), HelpPage::tr("Tab, Shift+Tab")},
                     {HelpPage::tr("Press a button, open a list"), HelpPage::tr("Enter")},
                     {HelpPage::tr("Open a menu"), HelpPage::tr("Alt and the underlined letter")},
                     {HelpPage::tr("Open a file"), HelpPage::tr("Drop it on the window")},
                     {HelpPage::tr("Leave what fills the screen"), QKeySequence(Qt::Key_Escape).toString()}});
    html += tableOf(
        HelpPage::tr("Mechanism"),
        {{HelpPage::tr("Move through time"), HelpPage::tr("Drag A, or B along its line")},
         {HelpPage::tr("Change a, b or c"),
          HelpPage::tr("Pull the crank, the coupler or the slider's line; with Control to a finer length")},
         {HelpPage::tr("Zoom"), HelpPage::tr("Wheel, + and -")},
         {HelpPage::tr("Show all"), HelpPage::tr("Double click beside the mechanism, or 0")},
         {HelpPage::tr("Make it large, and small again"), HelpPage::tr("Double click a link, or Enter")},
         {HelpPage::tr("Move the drawing"), HelpPage::tr("Drag beside the mechanism, or Control and the arrows")},
         {HelpPage::tr("Read about a part"), HelpPage::tr("Point at it, or Page Down and Page Up")}});
    html += tableOf(
        HelpPage::tr("Parameters"),
        {{HelpPage::tr("Change a little, a lot"), HelpPage::tr("On a slider: arrow keys, Page Up and Page Down")},
         {HelpPage::tr("Go there at once"), HelpPage::tr("Click the slider's line")},
         {HelpPage::tr("Type any number, with any unit: 2.5 cm, 60 rpm"),
          HelpPage::tr("In a box: the number, then Enter")},
         {HelpPage::tr("Take back what is being typed"), QKeySequence(Qt::Key_Escape).toString()}});
    html += tableOf(
        HelpPage::tr("Plots"),
        {{HelpPage::tr("Go to an instant"), HelpPage::tr("Click")},
         {HelpPage::tr("Read the values of all plots"), HelpPage::tr("Point at a curve")},
         {HelpPage::tr("Zoom the time"), HelpPage::tr("Wheel; + and − on a plot with the focus")},
         {HelpPage::tr("Zoom the values"), HelpPage::tr("Wheel left of the axis")},
         {HelpPage::tr("Zoom into a part"),
          HelpPage::tr("Drag a box around it; a flat one zooms the time alone, Escape cancels")},
         {HelpPage::tr("Move what is zoomed"), HelpPage::tr("Shift and drag, or drag with the middle button")},
         {HelpPage::tr("Show the whole run"), HelpPage::tr("Double click, or 0")},
         {HelpPage::tr("Make a plot large, and small again"), HelpPage::tr("Double click its title, or Enter")},
         {HelpPage::tr("Copy, export, choose the error"), HelpPage::tr("Right click, or the menu key")},
         {HelpPage::tr("Move a measuring cursor"), HelpPage::tr("Drag it, or 1 and 2 to bring it to the instant")}});
    html += tableOf(HelpPage::tr("Tables"),
                    {{HelpPage::tr("Go where a row's value is"), HelpPage::tr("Click, or Enter")},
                     {HelpPage::tr("Light up a row's joint"), HelpPage::tr("Point at it, or the arrow keys")},
                     {HelpPage::tr("Copy the rows that are chosen, or the table, as CSV"),
                      QKeySequence(QKeySequence::Copy).toString()},
                     {HelpPage::tr("Unfold the panels"), HelpPage::tr("Click a tab")}});
    return html;
}

QString formulasText()
{
    QString html = QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("What it does"));
    html +=
        paragraph(HelpPage::tr("It shows how an offset slider-crank moves with the lengths and the speed you choose, "
                               "and how far a motion exported from a simulation (CSV) is from it, and why."));
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("The mechanism"));
    html += paragraph(HelpPage::tr(
        "The crank, of length a, turns about O₂ at the constant speed ω₂. The coupler, of length b, leads from its pin "
        "A to the pin B of the slider, which moves along y = c. Superscripts number the bodies: 1 ground, 2 crank, 3 "
        "coupler, 4 slider. The crank angle is the one exception: it is θ₂ everywhere, also where Shabana writes θ²."));
    html += formulas({QStringLiteral("θ₂ = ω₂ t + θ₂₀")});
    html += paragraph(
        HelpPage::tr("The slider position Rₓ⁴ and its height R_y⁴ are measured from O₂, x along the slider's line, and "
                     "angles counter-clockwise from x. The program starts with the mechanism of Table 1 of a report, "
                     "the piece of course work that it grew from: a = 20, b = 65, c = 25 mm, one turn a second."));
    html += paragraph(HelpPage::tr("The coupler angle θ³ is seen from A towards B; the θ₃ that textbooks draw at B is "
                                   "θ³ + 180°. The crank makes full turns when"));
    html += formulas({QStringLiteral("a + |c| ≤ b")});
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("Closed form, exact"));
    html += paragraph(HelpPage::tr("Plus: open assembly, the slider to the right of A. Minus: crossed."));
    html += formulas({QStringLiteral("h = c − a sin θ₂"), QStringLiteral("sin θ³ = h / b,  cos θ³ = ± √(b² − h²) / b"),
                      QStringLiteral("Rₓ⁴ = a cos θ₂ + b cos θ³"), QStringLiteral("dθ³/dt = −a ω₂ cos θ₂ / (b cos θ³)"),
                      QStringLiteral("dRₓ⁴/dt = −a ω₂ sin θ₂ − b sin θ³ dθ³/dt"),
                      QStringLiteral("d²θ³/dt² = (a ω₂² sin θ₂ + b sin θ³ (dθ³/dt)²) / (b cos θ³)"),
                      QStringLiteral("d²Rₓ⁴/dt² = −a ω₂² cos θ₂ − b cos θ³ (dθ³/dt)² − b sin θ³ d²θ³/dt²")});
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("Newton-Raphson"));
    html +=
        paragraph(HelpPage::tr("The 12 coordinates q, centre of mass and angle of each body, satisfy 12 equations C(q, "
                               "t) = 0, after A. A. Shabana, <i>Computational Dynamics</i>. The position is iterated "
                               "until ‖C‖ is within the tolerance; velocity and acceleration follow from it. Where cos "
                               "θ³ = 0 the coupler is perpendicular to the slider's line and they do not exist."));
    html += formulas({QStringLiteral("C_q Δq = −C"), QStringLiteral("C_q q̇ = −Cₜ"),
                      QStringLiteral("C_q q̈ = Q_d = −(C_q q̇)_q q̇ − 2 C_qt q̇ − C_tt"),
                      QStringLiteral("det C_q = −b cos θ³")});
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("Error"));
    html += paragraph(
        HelpPage::tr("The error of the model against each value x of a file, as a percentage of x; where x is 0 there "
                     "is no percentage. The View menu has errors in ° and mm, and in percent of the peak."));
    html += formulas({HelpPage::tr("|model − x| / |x| · 100 %")});
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("Which mechanism a file belongs to"));
    html += paragraph(
        HelpPage::tr("A mechanism counts as found when all that it leaves unexplained in every column is rounding, or "
                     "looks like random noise; ± is one standard deviation. Where several explain the file equally "
                     "well, all are listed. With too few values, too few instants a turn or too small a part of a "
                     "turn, the program says what is missing. Where no mechanism was found, the nearest is shown as no "
                     "more than that; this does not prove that there is none."));
    html += paragraph(
        HelpPage::tr("The slider position Rₓ⁴ alone does not tell a mechanism from its mirror image; the coupler angle "
                     "θ³ alone determines only b/a and c/a. A column may be measured from elsewhere than O₂, as a "
                     "slider joint's own coordinate is, or mean another unit, sign or angle than its name says: the "
                     "program shows the error before and after, and changes nothing without being asked."));
    html += QStringLiteral("<h3>%1</h3>").arg(HelpPage::tr("How exact the numbers can be"));
    html += paragraph(HelpPage::tr("The study compares every method with a computation in 50 digits or more, and with "
                                   "κ·u: how much a channel f can change just because each given number p is rounded "
                                   "to the 16 digits of a double, by u of itself at most."));
    html +=
        formulas({QStringLiteral("κ = Σ |p ∂f/∂p|,  p = a, b, c, ω₂, θ₂₀, t"), QStringLiteral("u = 2⁻⁵³ = 1.1·10⁻¹⁶")});
    return html;
}

HelpPage::HelpPage(const QString &title, const QString &html, QWidget *window)
    : QDialog(window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("helpPage"));
    setWindowTitle(title);
    auto *text = new QTextBrowser;
    text->setObjectName(QStringLiteral("helpText"));
    text->setAccessibleName(title);
    text->setHtml(html);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto *rows = new QVBoxLayout(this);
    rows->addWidget(text);
    rows->addWidget(buttons);
    const int letter = fontMetrics().averageCharWidth();
    resize(90 * letter, 90 * letter);
}

} // namespace slidercrank
