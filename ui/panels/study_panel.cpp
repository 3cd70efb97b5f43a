// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_panel.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/save_dialog.h"
#include "ui/document/whole_file.h"
#include "ui/export/figure_export.h"
#include "ui/panels/study_figure.h"
#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"
#include "ui/text/study_text.h"
#include "ui/text/written_number.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QStandardPaths>
#include <QStringList>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr QSize kExportSize(900, 600);
constexpr int kProgressSteps = 200;
constexpr int kDigits = 3;

QString statusText(Status status)
{
    switch (status) {
    case Status::Solved: return StudyPanel::tr("solved");
    case Status::Singular: return StudyPanel::tr("singular");
    case Status::IterationLimit: return StudyPanel::tr("not converged");
    case Status::NotAssemblable: return StudyPanel::tr("not assemblable");
    case Status::NotFinite: return StudyPanel::tr("not finite");
    }
    return {};
}

/// "solved", or "190 solved, 11 singular".
QString outcomeOf(const MethodResult &row)
{
    QStringList parts;
    int statuses = 0;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        if (row.counts[i] > 0) {
            ++statuses;
            parts += StudyPanel::tr("%1 %2").arg(row.counts[i]).arg(statusText(static_cast<Status>(i)));
        }
    }
    QString text = statuses == 1 ? statusText(row.status) : parts.join(StudyPanel::tr(", "));
    if (row.silentFailures.value_or(0) > 0) {
        text += StudyPanel::tr(", %1 silently wrong").arg(*row.silentFailures);
    }
    return text;
}

std::size_t silentFailuresOf(const StudyResult &result)
{
    std::size_t sum = 0;
    for (const CaseResult &which : result.cases) {
        for (const MethodResult &row : which.methods) {
            sum += row.silentFailures.value_or(0);
        }
    }
    return sum;
}

/// They are powers of ten, or 0.
QString toleranceOf(const MethodResult &row)
{
    return row.tolerance.value_or(0.0) > 0.0 ? powerOfTen(static_cast<int>(std::lround(std::log10(*row.tolerance))))
                                             : numberText(row.tolerance, kDigits);
}

/// As in the picture.
QIcon markOf(const MethodResult &method, const QWidget &where)
{
    constexpr double kSide = 13.0; // px
    QPixmap pixmap((QSizeF(kSide, kSide) * where.devicePixelRatioF()).toSize());
    pixmap.setDevicePixelRatio(where.devicePixelRatioF());
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    drawMark(painter, {0.5 * kSide, 0.5 * kSide}, method, seriesColours(where.palette()));
    return QIcon(pixmap);
}

QString lengthsOf(const Parameters &p)
{
    const auto number = [](double value) { return numberText(value, 9); };
    return StudyPanel::tr("a = %1 mm, b = %2 mm, c = %3 mm, ω₂ = %4 rad/s, θ₂₀ = %5 rad, %6")
        .arg(number(p.a), number(p.b), number(p.c), number(p.omega2), number(p.theta20), assemblyText(p.branch));
}

} // namespace

/// The picture on the screen: its points answer to the mouse.
class StudyPicture : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPicture(QWidget *parent = nullptr)
        : QWidget(parent)
    {
        named("studyPicture", this, tr("Error against time per state"));
        setMouseTracking(true);
        setMinimumSize(220, 120);
    }

    void setCase(const CaseResult *which)
    {
        m_case = which ? std::optional(*which) : std::nullopt;
        m_marked.reset();
        QStringList best;
        if (m_case) {
            for (const std::size_t row : bestFront(*m_case)) {
                best += titleOf(m_case->methods[row]);
            }
        }
        setAccessibleDescription(best.isEmpty() ? QString()
                                                : tr("Best in speed and error: %1").arg(best.join(tr(", "))));
        update();
    }

    void mark(std::optional<std::size_t> row)
    {
        if (row != m_marked) {
            m_marked = row;
            update();
        }
    }

signals:
    void pointed(std::size_t row); ///< at a point

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        const SeriesColours colours = seriesColours(palette());
        if (m_case) {
            drawStudy(painter, size(), *m_case, colours, m_marked);
            return;
        }
        painter.fillRect(rect(), colours.background);
        painter.setPen(colours.text);
        painter.drawText(rect().adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("How fast is each method, and how exact? Run the study: every method is timed on the same "
                            "instants, and its error measured against a computation in 50 digits or more."));
    }

    void mouseMoveEvent(QMouseEvent *event) override
    {
        if (const std::optional<std::size_t> row = rowAt(event->position())) {
            mark(row);
            QToolTip::showText(event->globalPosition().toPoint(), descriptionOf(m_case->methods[*row]), this);
            emit pointed(*row);
        } else {
            QToolTip::hideText();
        }
    }

private:
    std::optional<std::size_t> rowAt(const QPointF &position) const
    {
        constexpr double kNear = 9.0; // px
        std::optional<std::size_t> nearest;
        double least = kNear;
        if (m_case) {
            for (const StudyPoint &point : studyPoints(*m_case, size())) {
                const double away = std::hypot(point.at.x() - position.x(), point.at.y() - position.y());
                if (away <= least) {
                    least = away;
                    nearest = point.row;
                }
            }
        }
        return nearest;
    }

    std::optional<CaseResult> m_case;
    std::optional<std::size_t> m_marked;
};

StudyPanel::StudyPanel(QWidget *parent)
    : QWidget(parent)
    , m_study(new WorkAside(WorkAside::Kind::Lasting, this))
{
    named("studyPanel", this, tr("Speed and accuracy of the methods"));

    m_runThis = named("runThisButton", new QPushButton(tr("Run (this mechanism)")));
    m_runThis->setToolTip(tr("Times every method on one turn of this mechanism"));
    connect(m_runThis, &QPushButton::clicked, this, &StudyPanel::runThisMechanism);
    m_runHard = named("runHardButton", new QPushButton(tr("Run hard cases")));
    m_runHard->setToolTip(tr("Cranks that only just turn or only rock, very long and very short links, very late "
                             "instants: takes some ten seconds"));
    connect(m_runHard, &QPushButton::clicked, this, &StudyPanel::runHardCases);
    m_cancel = named("cancelStudyButton", new QPushButton(tr("Cancel")));
    connect(m_cancel, &QPushButton::clicked, this, &StudyPanel::cancel);
    m_progress = named("studyProgress", new QProgressBar, tr("Progress of the study"));
    m_progress->setRange(0, kProgressSteps);
    m_progress->setMaximumWidth(140);

    m_cases = named("caseBox", new QComboBox, tr("Case shown"));
    m_cases->setToolTip(tr("Case shown"));
    m_cases->setMinimumContentsLength(12);
    m_cases->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(m_cases, &QComboBox::currentIndexChanged, this, &StudyPanel::showCase);

    m_export = named("exportStudyButton", new QToolButton);
    m_export->setText(tr("Export"));
    m_export->setToolTip(tr("The picture as PNG, SVG or PDF, the numbers as CSV or JSON"));
    m_export->setPopupMode(QToolButton::InstantPopup);
    auto *menu = new QMenu(m_export);
    menu->addAction(tr("Picture…"), this, &StudyPanel::choosePicture);
    menu->addAction(tr("Numbers…"), this, &StudyPanel::chooseNumbers);
    m_export->setMenu(menu);

    m_summary = named("studySummary", new QLabel);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_answer = named("studyAnswer", plainText());

    auto *controls = new QHBoxLayout;
    controls->setSpacing(6);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_runThis, m_runHard, m_cancel, m_progress}) {
        controls->addWidget(widget);
    }
    controls->addWidget(m_summary, 1);
    controls->addWidget(m_cases);
    controls->addWidget(m_export);

    m_picture = new StudyPicture;
    m_table = new NumberTable(
        QStringLiteral("studyTable"), tr("Methods, a row a method and tolerance"),
        {{tr("method"), tr("How the motion is computed"), QStringLiteral("method"), false},
         {tr("tolerance"), tr("Of Newton-Raphson: absolute for the report's way, relative for the others"),
          QStringLiteral("tolerance")},
         {tr("time [ns]"),
          tr("Per state, that is position, velocity and acceleration at an instant: median over interleaved rounds"),
          QStringLiteral("time [ns]")},
         {tr("error"),
          tr("The worst of the six plotted channels, relative to the channel's peak, over solved instants"),
          QStringLiteral("error")},
         {tr("iterations"), tr("Per state"), QStringLiteral("iterations")},
         {tr("instants"), tr("What the method says of them"), QStringLiteral("instants"), false}},
        TableLook::Striped);
    connect(m_table, &NumberTable::copied, this, &StudyPanel::rowsCopied);
    m_table->hide(); // until there is something in it
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &now) {
        m_picture->mark(now.isValid() ? std::optional(static_cast<std::size_t>(now.row())) : std::nullopt);
    });
    connect(m_picture, &StudyPicture::pointed, this,
            [this](std::size_t row) { m_table->setCurrentIndex(m_table->model()->index(static_cast<int>(row), 0)); });

    m_beside = new QSplitter(Qt::Horizontal);
    m_beside->setChildrenCollapsible(false);
    m_beside->addWidget(m_picture);
    m_beside->addWidget(m_table);
    connect(m_beside, &QSplitter::splitterMoved, this, [this] { m_isSharedByHand = true; });

    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 4, 6, 4);
    rows->setSpacing(4);
    rows->addLayout(controls);
    rows->addWidget(m_answer);
    rows->addWidget(m_beside, 1);
    listen();
    updateButtons();
    showSummary();
}

void StudyPanel::listen()
{
    connect(m_study, &WorkAside::progressed, this,
            [this](double part) { m_progress->setValue(static_cast<int>(part * kProgressSteps)); });
    connect(m_study, &WorkAside::runningChanged, this, [this](bool running) {
        updateButtons();
        if (!running) {
            emit finished();
        }
    });
}

void StudyPanel::takeOver(StudyPanel &other)
{
    delete std::exchange(m_study, std::exchange(other.m_study, nullptr));
    m_study->disconnect(&other);
    m_study->setParent(this);
    listen();
    m_progress->setValue(other.m_progress->value());
    setResult(other.m_result);
    m_cases->setCurrentIndex(other.m_cases->currentIndex());
}

void StudyPanel::setParameters(const Parameters &parameters)
{
    m_parameters = parameters;
    showSummary();
}

void StudyPanel::runThisMechanism()
{
    run({.cases = {studyCase(m_parameters)}});
}

void StudyPanel::runHardCases()
{
    run({.cases = {hardCases().begin(), hardCases().end()}});
}

void StudyPanel::cancel()
{
    m_study->cancel();
}

void StudyPanel::run(StudyRequest request)
{
    if (m_study->isRunning()) {
        return;
    }
    m_progress->setValue(0);
    // The one that has taken it over by then.
    const auto panel = [study = m_study] { return static_cast<StudyPanel *>(study->parent()); };
    m_study->start(
        [request = std::move(request)](const std::stop_token &stop, const WorkAside::Progress &progress) {
            return std::make_shared<const StudyResult>(runStudy(request, stop, progress));
        },
        [panel](const std::shared_ptr<const StudyResult> &result) {
            if (!result->cases.empty()) {
                panel()->setResult(result);
            }
        },
        [panel](const QString &sentence) { emit panel()->problemFound(sentence); });
}

void StudyPanel::setResult(const std::shared_ptr<const StudyResult> &result)
{
    m_result = result;
    updateButtons();
    if (!m_result) {
        return;
    }
    const QSignalBlocker quiet(m_cases);
    m_cases->clear();
    for (const CaseResult &which : m_result->cases) {
        m_cases->addItem(caseText(which.name));
    }
    showCase();
}

const CaseResult *StudyPanel::shownCase() const
{
    const int index = m_cases->currentIndex();
    return m_result && index >= 0 ? &m_result->cases[static_cast<std::size_t>(index)] : nullptr;
}

void StudyPanel::showCase()
{
    const CaseResult *which = shownCase();
    m_picture->setCase(which);
    if (which) {
        fillTable(*which);
        m_cases->setToolTip(lengthsOf(which->parameters));
    }
    m_table->setVisible(which != nullptr);
    showSummary();
}

void StudyPanel::fillTable(const CaseResult &which)
{
    std::vector<TableRow> rows;
    for (const MethodResult &method : which.methods) {
        TableRow row;
        row.cells = {{.text = titleOf(method)},
                     {.text = toleranceOf(method), .number = method.tolerance},
                     {.text = shortNumber(method.nsPerState, kDigits), .number = method.nsPerState},
                     {.text = shortNumber(method.maxError, kDigits), .number = method.maxError},
                     {.text = shortNumber(method.iterationsPerState, kDigits), .number = method.iterationsPerState},
                     {.text = outcomeOf(method)}};
        for (TableCell &cell : row.cells) {
            cell.explanation = descriptionOf(method);
        }
        row.cells.front().mark = markOf(method, *this);
        if (method.silentFailures.value_or(0) > 0) {
            row.cells.back().ink = seriesColours(palette()).warning;
        }
        rows.push_back(std::move(row));
    }
    m_table->setCurrentIndex({});
    m_table->setRows(std::move(rows));
    m_table->fitToContents();
    shareTheRoom();
}

/// The table as wide as what it holds, as far as the picture keeps enough.
void StudyPanel::shareTheRoom()
{
    if (m_isSharedByHand) {
        return;
    }
    constexpr double kMostOfTable = 0.6;
    const int width = m_beside->width();
    const int needed = m_table->horizontalHeader()->length() + m_table->verticalScrollBar()->sizeHint().width();
    const int given = std::min(needed, static_cast<int>(kMostOfTable * width));
    m_beside->setSizes({width - m_beside->handleWidth() - given, given});
}

void StudyPanel::showSummary()
{
    QString text;
    if (m_result) {
        text = m_result->cases.size() == 1 ? tr("1 case") : tr("%1 cases").arg(m_result->cases.size());
        const std::size_t silent = silentFailuresOf(*m_result);
        text += silent == 0 ? tr(", nothing silently wrong") : tr(", ⚠ %1 instants silently wrong").arg(silent);
        text += tr(", done in %1 s").arg(QLocale().toString(m_result->seconds, 'f', 1));
        if (!m_result->complete) {
            text += tr(" (cancelled)");
        }
        m_summary->setToolTip(tr("Times of %1").arg(machineText(m_result->machine)));
    }
    m_summary->setText(text);
    const CaseResult *which = shownCase();
    QString answer = which ? closedFormSentence(*which) : QString();
    const bool ofThisMechanism = which && which->name == studyCase(which->parameters).name;
    if (ofThisMechanism && which->parameters != m_parameters) {
        answer += tr(" The mechanism has changed since: run again.");
    }
    m_answer->setText(answer.trimmed());
    m_answer->setVisible(!answer.isEmpty());
}

void StudyPanel::updateButtons()
{
    m_runThis->setEnabled(!m_study->isRunning());
    m_runHard->setEnabled(!m_study->isRunning());
    m_cancel->setVisible(m_study->isRunning());
    m_progress->setVisible(m_study->isRunning());
    m_cases->setVisible(m_result && m_result->cases.size() > 1);
    m_export->setEnabled(m_result != nullptr);
}

std::optional<QString> StudyPanel::exportPicture(const QString &path) const
{
    const CaseResult *which = shownCase();
    if (!which) {
        return tr("There is nothing to export yet: run the study first.");
    }
    const SeriesColours light = seriesColours(paletteFor(Theme::Light));
    return exportFigure(path, {kExportSize, 2.0}, tr("Speed and accuracy: %1").arg(caseText(which->name)),
                        [&](QPainter &painter, const QSize &size) { drawStudy(painter, size, *which, light); });
}

std::optional<QString> StudyPanel::exportNumbers(const QString &path) const
{
    if (!m_result) {
        return tr("There is nothing to export yet: run the study first.");
    }
    const bool json = path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive);
    const std::optional<QString> reason =
        writeWhole(path, QByteArray::fromStdString(json ? studyJson(*m_result) : studyCsv(*m_result)));
    return reason ? std::optional(tr("%1 cannot be written: %2.").arg(QDir::toNativeSeparators(path), *reason))
                  : std::nullopt;
}

void StudyPanel::choosePicture()
{
    chooseFileToSave(this,
                     {tr("Export"), figureFilters(), lastFolder(QStandardPaths::PicturesLocation), tr("speed.png"),
                      [this](const QString &path, const QString &) { tellProblem(exportPicture(path)); }});
}

void StudyPanel::chooseNumbers()
{
    chooseFileToSave(this, {tr("Export"),
                            {tr("Tables (*.csv)"), QStringLiteral("JSON (*.json)")},
                            lastFolder(QStandardPaths::DocumentsLocation),
                            tr("speed.csv"),
                            [this](const QString &path, const QString &) { tellProblem(exportNumbers(path)); }});
}

void StudyPanel::tellProblem(const std::optional<QString> &sentence)
{
    if (sentence) {
        emit problemFound(*sentence);
    }
}

void StudyPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    shareTheRoom();
}

void StudyPanel::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LocaleChange) {
        showCase();
    }
    QWidget::changeEvent(event);
}

} // namespace slidercrank

#include "study_panel.moc"
