// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_form.h"

#include "ui/document/view_settings.h"
#include "ui/text/written_number.h"
#include "ui/widgets/enum_box.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/save_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSettings>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using WidthUnit = FigureOptions::Unit;

constexpr QSize kMinPreviewSize(120, 120); // px
constexpr QSize kMaxPreviewSize(460, 460); // px

const QString kWidth = "export/width";
const QString kUnit = "export/unit";
const QString kFontSize = "export/fontSize";
const QString kPlots = "export/plots";
const QString kCursor = "export/cursor";
const QString kFormat = "export/format";

} // namespace

FigureOptions storedFigureOptions()
{
    const QSettings settings;
    FigureOptions options;
    options.unit = settings.value(kUnit).toString() == u"px" ? WidthUnit::Pixel : WidthUnit::Millimetre;
    const bool isInPixels = options.unit == WidthUnit::Pixel;
    options.width =
        std::clamp(settings.value(kWidth, options.width).toDouble(), isInPixels ? kMinFigureWidthPx : kMinFigureWidthMm,
                   isInPixels ? kMaxFigureWidthPx : kMaxFigureWidthMm);
    options.fontSize = std::clamp(settings.value(kFontSize, options.fontSize).toDouble(), kSmallestFont, kLargestFont);
    options.plots = settings.value(kPlots).toStringList();
    options.showsCursor = settings.value(kCursor, false).toBool();
    options.format = figureFormat("x." + settings.value(kFormat).toString()).value_or(FigureFormat::Png);
    return options;
}

void storeFigureOptions(const FigureOptions &options)
{
    QSettings settings;
    settings.setValue(kWidth, options.width);
    settings.setValue(kUnit, options.unit == WidthUnit::Pixel ? "px" : "mm");
    settings.setValue(kFontSize, options.fontSize);
    settings.setValue(kPlots, options.plots);
    settings.setValue(kCursor, options.showsCursor);
    settings.setValue(kFormat, suffixOf(options.format));
}

std::optional<QString> exportFigure(const QString &path, const FigureSubject &subject, const FigureOptions &options)
{
    return drawFigure(path, subject, options)({});
}

FigureWriter drawFigure(const QString &path, const FigureSubject &subject, const FigureOptions &options)
{
    const FigureSize size = figureSize(options, subject.height(options));
    return drawFigure(path, size, FigureForm::tr("Motion of an offset slider-crank"), subject.draw(options));
}

void chooseFigure(QWidget *parent, const FigureSubject &subject,
                  const std::function<void(const FigureOptions &, const QString &path)> &write)
{
    auto *form = new FigureForm(subject, storedFigureOptions(), parent);
    form->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(form, &QDialog::accepted, parent, [form, parent, subject, write] {
        const FigureOptions options = form->options();
        FigureOptions stored = options; // an option that this figure does not offer keeps its stored value
        stored.plots = options.plots.isEmpty() ? storedFigureOptions().plots : options.plots;
        stored.showsCursor = subject.hasCursor ? options.showsCursor : storedFigureOptions().showsCursor;
        storeFigureOptions(stored);
        QStringList filters = figureFilters();
        const QString suffix = suffixOf(options.format);
        std::stable_partition(filters.begin(), filters.end(),
                              [&](const QString &filter) { return suffixOf(filter) == suffix; });
        chooseFileToSave(parent, {FigureForm::tr("Export"), filters, subject.name,
                                  [options, write](const QString &path, const QString &) { write(options, path); }});
    });
    form->open();
}

FigureForm::FigureForm(const FigureSubject &subject, const FigureOptions &options, QWidget *parent)
    : QDialog(parent)
    , m_subject(subject)
    , m_width(named("widthBox", new NumberBox))
    , m_unit(named("unitBox", new QComboBox))
    , m_fontSize(named("fontSizeBox", new NumberBox))
    , m_format(named("formatBox", new QComboBox))
    , m_cursor(named("cursorBox", new QCheckBox(tr("&Values at the current time"))))
    , m_preview(named("previewLabel", new QLabel))
    , m_summary(named("outcomeLabel", new QLabel))
{
    named("figureForm", this);
    setWindowTitle(tr("Export"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    prepareFields(options);
    QLayout *form = makeForm();
    QLayout *plots = makePlotBoxes(options);
    enum Row { Fields, Plots, Buttons };
    enum Column { Left, Preview, ColumnCount };
    auto *layout = new QGridLayout(this);
    layout->addLayout(form, Fields, Left);
    layout->setColumnMinimumWidth(Left, form->sizeHint().width()); // otherwise the preview cuts long labels
    layout->addWidget(m_preview, Fields, Preview);
    layout->addLayout(plots, Plots, Left, 1, ColumnCount); // beside the preview, their names would leave it no width
    layout->addWidget(buttons, Buttons, Left, 1, ColumnCount);
    fitPreview(QSize(form->sizeHint().width(), plots->sizeHint().height() + buttons->sizeHint().height()));
    layout->setColumnStretch(Preview, 1);
    connect(m_width, &NumberBox::edited, this, &FigureForm::showPreview);
    connect(m_fontSize, &NumberBox::edited, this, &FigureForm::showPreview);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &FigureForm::changeUnit);
    connect(m_format, &QComboBox::currentIndexChanged, this, &FigureForm::showPreview);
    connect(m_cursor, &QCheckBox::toggled, this, &FigureForm::showPreview);
    showPreview();
}

/// Gives the fields their choices and the values of the options.
void FigureForm::prepareFields(const FigureOptions &options)
{
    addChoice(m_unit, WidthUnit::Millimetre, tr("mm"));
    addChoice(m_unit, WidthUnit::Pixel, tr("px"));
    choose(m_unit, options.unit);
    m_unit->setAccessibleName(tr("Unit of the width"));
    limitWidth();
    m_width->setValue(options.width);
    m_fontSize->setRange(kSmallestFont, kLargestFont);
    m_fontSize->setValue(options.fontSize);
    m_fontSize->setSuffix(tr(" pt"));
    addChoice(m_format, FigureFormat::Png, "PNG");
    addChoice(m_format, FigureFormat::Svg, "SVG");
    addChoice(m_format, FigureFormat::Pdf, "PDF");
    choose(m_format, options.format);
    m_cursor->setChecked(options.showsCursor);
    m_cursor->setVisible(m_subject.hasCursor);
    m_preview->setFrameShape(QFrame::Box);
    m_preview->setAlignment(Qt::AlignCenter);
    m_preview->setAccessibleName(tr("Preview"));
    m_summary->setWordWrap(true);
}

/// Makes the preview so small that the dialog fits the screen. `occupied`: the width beside the preview and the height
/// below it, px.
void FigureForm::fitPreview(const QSize &occupied)
{
    constexpr QSize kMargins(60, 100); // px, with the space between the rows, the frame and the title bar
    const QSize available = screen()->availableSize() - occupied - kMargins;
    m_preview->setMinimumSize(available.boundedTo(kMaxPreviewSize).expandedTo(kMinPreviewSize));
}

QLayout *FigureForm::makeForm()
{
    auto *width = new QHBoxLayout;
    width->addWidget(m_width);
    width->addWidget(m_unit);
    auto *form = new QFormLayout;
    auto *label = new QLabel(tr("&Width"));
    label->setBuddy(m_width);
    form->addRow(label, width);
    form->addRow(tr("&Font size"), m_fontSize);
    form->addRow(tr("F&ormat"), m_format);
    form->addRow(m_cursor);
    form->addRow(m_summary);
    return form;
}

/// Arranges a check box for each plot as the plots are arranged in the window.
QLayout *FigureForm::makePlotBoxes(const FigureOptions &options)
{
    const bool hasErrorPlots = m_subject.plots.size() >= kPlotCount;
    const int columns = static_cast<int>(hasErrorPlots ? kPlotColumns : kErrorColumn);
    auto *grid = new QGridLayout;
    const auto isChosen = [&](const QString &name) { return options.plots.isEmpty() || options.plots.contains(name); };
    // If none of the plots is chosen, the stored choice is that of a different figure: then all plots are checked.
    const bool isAnyChosen = std::ranges::any_of(m_subject.plots, isChosen, &NamedPlot::name);
    for (const auto &[name, text] : m_subject.plots) {
        auto *box = named(name, new QCheckBox(text));
        box->setChecked(!isAnyChosen || isChosen(name));
        connect(box, &QCheckBox::toggled, this, &FigureForm::showPreview);
        const int place = static_cast<int>(m_plots.size());
        grid->addWidget(box, place / columns, place % columns);
        m_plots.push_back(box);
    }
    return grid;
}

FigureOptions FigureForm::options() const
{
    FigureOptions options;
    options.width = m_width->value();
    options.unit = chosen<WidthUnit>(m_unit);
    options.fontSize = m_fontSize->value();
    options.format = chosen<FigureFormat>(m_format);
    options.showsCursor = m_subject.hasCursor && m_cursor->isChecked();
    for (const QCheckBox *box : m_plots) {
        if (box->isChecked()) {
            options.plots << box->objectName();
        }
    }
    return options;
}

/// Gives the width the limits of its unit. In mm, it may be typed in other units of length.
void FigureForm::limitWidth()
{
    if (chosen<WidthUnit>(m_unit) == WidthUnit::Pixel) {
        m_width->setRange(kMinFigureWidthPx, kMaxFigureWidthPx);
        m_width->clearUnit();
    } else {
        m_width->setRange(kMinFigureWidthMm, kMaxFigureWidthMm);
        m_width->setUnit(kMillimetre);
    }
}

/// Converts the width, so that the figure keeps its size where the limits of the unit allow it.
void FigureForm::changeUnit()
{
    constexpr double kPixelsPerMm = kLogicalPixelsPerInch / kMmPerInch;
    const bool isInPixels = chosen<WidthUnit>(m_unit) == WidthUnit::Pixel;
    const double width = m_width->value();
    limitWidth();
    m_width->setValue(isInPixels ? std::round(width * kPixelsPerMm) : width / kPixelsPerMm);
    showPreview();
}

void FigureForm::showPreview()
{
    FigureOptions chosen = options();
    const bool isInPixels = chosen.unit == WidthUnit::Pixel;
    const bool hasPlots = m_plots.empty() || !chosen.plots.isEmpty();
    m_export->setEnabled(hasPlots);
    if (!hasPlots) {
        m_preview->setPixmap({});
        m_summary->setText(tr("Choose a plot."));
        return;
    }
    FigureSize size = figureSize(chosen, m_subject.height(chosen));
    const QSizeF pixels = QSizeF(size.size) * size.scale;
    const QSizeF paper = QSizeF(size.size) * size.paperPixel * (kMmPerInch / kLogicalPixelsPerInch);
    m_summary->setText(chosen.format == FigureFormat::Png || isInPixels
                           ? tr("%1 × %2 px").arg(qRound(pixels.width())).arg(qRound(pixels.height()))
                           : tr("%1 × %2 mm").arg(fixedText(paper.width(), 1), fixedText(paper.height(), 1)));
    const QSizeF previewSize = QSizeF(size.size).scaled(QSizeF(m_preview->minimumSize()), Qt::KeepAspectRatio);
    size.scale = devicePixelRatioF() * previewSize.width() / size.size.width();
    QPixmap picture = QPixmap::fromImage(figureImage(size, m_subject.draw(chosen)));
    picture.setDevicePixelRatio(devicePixelRatioF());
    m_preview->setPixmap(picture);
}

} // namespace slidercrank

#include "moc_figure_form.cpp"
