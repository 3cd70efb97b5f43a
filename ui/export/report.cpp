// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report.h"

#include "ui/document/whole_file.h"
#include "ui/text/column_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextObjectInterface>

#include <algorithm>
#include <vector>

namespace slidercrank
{

namespace
{

struct Report {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::Report)
};

QString element(const char *tag, const QString &text)
{
    return QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped().replace(u'\n', "<br>"));
}

QString heading(const QString &text)
{
    return element("h2", text);
}

QString paragraph(const QString &text)
{
    return text.isEmpty() ? QString() : element("p", text);
}

QString note(const QString &text)
{
    return text.isEmpty() ? QString() : QStringLiteral("<div class=note>%1</div>").arg(element("p", text));
}

QString newPage(const QString &title)
{
    return QStringLiteral("<div style='page-break-before:always'>%1</div>").arg(heading(title));
}

/// Returns an HTML table. The first row is the header. All columns but the first are right-aligned.
QString table(const std::vector<QStringList> &rows)
{
    QString html = "<table cellspacing=0 cellpadding=2>";
    for (const QStringList &row : rows) {
        html += "<tr>";
        for (qsizetype i = 0; i < row.size(); ++i) {
            const char *tag = &row == &rows.front() ? "th" : "td";
            html += QStringLiteral("<%1 align=%2>%3&nbsp;&nbsp;</%1>")
                        .arg(QLatin1String(tag), QLatin1String(i == 0 ? "left" : "right"), row[i].toHtmlEscaped());
        }
        html += "</tr>";
    }
    return html + "</table>";
}

bool isFound(const ReportContent &content)
{
    return content.result->reference && content.diagnosis.identification.hasMechanism();
}

/// Returns the table of the parameters of the model and of the mechanism found for the file.
QString parameterTable(const ReportContent &content)
{
    const Parameters &model = content.result->mechanism.parameters();
    const Identification &found = content.diagnosis.identification;
    std::vector<QStringList> rows{{QString(), Report::tr("model")}};
    for (const Parameter parameter : kAllParameters) {
        rows.push_back({QStringLiteral("%1, %2").arg(symbolText(parameter), parameterName(parameter)),
                        parameterText(parameter, valueOf(model, parameter))});
    }
    rows.push_back({Report::tr("assembly"), assemblyText(model.branch)});
    if (isFound(content)) {
        rows.front() << (found.outcome == Identification::Outcome::Identified ? Report::tr("found in the file")
                                                                              : Report::tr("one of those found"));
        for (std::size_t i = 0; i < kAllParameters.size(); ++i) {
            rows[i + 1] << measuredText(kAllParameters[i], found);
        }
        rows.back() << assemblyText(found.parameters.branch);
    }
    return table(rows);
}

QString pinnedText(const Result &result)
{
    QStringList motions;
    for (const Parameters &pinned : result.pinned) {
        motions << pinnedText(pinned, result.mechanism.parameters());
    }
    return motions.isEmpty() ? QString() : Report::tr("Thin curves: pinned motions, %1.").arg(motions.join(u", "));
}

/// Returns the description of the reference: the files, and how their columns were interpreted.
QString fileText(const Reference &reference)
{
    const ReferenceData &data = reference.data;
    QString html =
        paragraph(Report::tr("Reference: %1, %2, %3 rows.")
                      .arg(displayName(reference.paths), abscissaText(data), QString::number(data.time.size())));
    for (const QString &doubt : doubtTexts(data)) {
        html += note(doubt);
    }
    return html;
}

/// Returns the section about the reference: the verdict, the mechanism found and the errors.
QString comparisonText(const ReportContent &content)
{
    const Result &result = *content.result;
    const Diagnosis &diagnosis = content.diagnosis;
    QString html = newPage(Report::tr("Errors: model against reference")) + fileText(*result.reference) +
                   QStringLiteral("<b>%1</b>").arg(paragraph(summaryText(result.comparison)));
    for (const QString &line : explanationLines(diagnosis, result.reference->data, result.mechanism)) {
        html += paragraph(line);
    }
    if (isFound(content)) {
        html += paragraph(roundNumbersText(diagnosis)) +
                note(Report::tr("Found by weighted least squares; ± is one standard error."));
    }
    return html + table(comparisonTable(result.comparison, result.reference->data)) +
           note(Report::tr("Largest %: max |model − reference| / |reference| · 100 where the reference is not zero. "
                           "Rounding step: the distance of neighbouring numbers in the file, where it is largest."));
}

QString methodText(const Result &result)
{
    const NewtonOptions &newton = result.solver.newton;
    const Sampling &sampling = result.sampling;
    const SamplingSummary &summary = result.summary;
    QString text;
    if (result.solver.method == Method::ClosedForm) {
        text = Report::tr("Closed form, exact to rounding.");
    } else {
        text =
            Report::tr("Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %3 iterations per "
                       "time step. Iterations: %4; largest residual: %5.")
                .arg(numberText(newton.tolerance),
                     newton.toleranceKind == ToleranceKind::Absolute ? Report::tr("absolute") : Report::tr("relative"),
                     QString::number(newton.maxIterations), iterationsText(summary),
                     numberText(summary.largestResidual, 2));
    }
    text +=
        u' ' + Report::tr("%1 time steps from t = %2 s to %3 s, %4 of them solved.")
                   .arg(QString::number(summary.timeSteps), numberText(sampling.start),
                        numberText(sampling.start + sampling.duration), QString::number(summary.count(Status::Solved)));
    return text + u' ' + fewSamplesSentence(result.mechanism, sampling);
}

#ifdef Q_MOC_RUN // moc reads no headers of Qt
Q_DECLARE_INTERFACE(QTextObjectInterface, "org.qt-project.Qt.QTextObjectInterface")
#endif

/// Draws vector graphics within the text.
class DrawingObject : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    /// The drawing is made for the logical size and scaled to the width.
    DrawingObject(const FigureDrawing &draw, const QSize &size, double width)
        : m_draw(draw)
        , m_size(size)
        , m_scale(width / size.width())
    {
    }

    QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &) override { return m_scale * QSizeF(m_size); }
    void drawObject(QPainter *painter, const QRectF &box, QTextDocument *, int, const QTextFormat &) override
    {
        painter->save();
        painter->translate(box.topLeft());
        painter->scale(m_scale, m_scale);
        m_draw(*painter, m_size);
        painter->restore();
    }

private:
    FigureDrawing m_draw;
    QSize m_size;
    double m_scale;
};

void insertDrawing(QTextDocument &document, const QString &placeholder, int type, DrawingObject &drawing)
{
    document.documentLayout()->registerHandler(type, &drawing);
    QTextCharFormat format;
    format.setObjectType(type);
    document.find(placeholder).insertText(QString(QChar::ObjectReplacementCharacter), format);
}

} // namespace

QString reportHtml(const ReportContent &content)
{
    const Result &result = *content.result;
    QString caption;
    if (result.isCompared()) {
        caption = result.reference ? Report::tr("Thin lines: the motion in the file.")
                                   : Report::tr("Thin lines: the pinned mechanism.");
    }
    return element("h1", Report::tr("Motion of an offset slider-crank")) +
           note(Report::tr("%1, by %2 %3")
                    .arg(QLocale().toString(content.written, QLocale::LongFormat), QCoreApplication::applicationName(),
                         QCoreApplication::applicationVersion())) +
           QStringLiteral("<table width=100%><tr><td>%1</td><td align=right>[mechanism]%2</td></tr></table>")
               .arg(parameterTable(content), note(caption)) +
           heading(Report::tr("Motion limits")) + paragraph(mobilitySentence(result.mechanism, result.limits)) +
           table(limitTable(motionFacts(result.mechanism, result.limits, result.sampling))) +
           newPage(Report::tr("Motion")) + paragraph(pinnedText(result)) + "<p>[figure]</p>" +
           (result.reference ? comparisonText(content) : QString()) + heading(Report::tr("Method")) +
           paragraph(methodText(result));
}

std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure)
{
    constexpr double kTextWidth = 640.0; // A4 without margins of 2 cm, at 96 dots per inch
    DrawingObject mechanismObject(mechanism, {560, 380}, 280.0);
    DrawingObject figureObject(figure, {900, 1200}, kTextWidth);
    QTextDocument document;
    QFont font = QGuiApplication::font();
    font.setPointSizeF(8.5);
    document.setDefaultFont(font);
    document.setDefaultStyleSheet(QStringLiteral(
        "h1 {font-size: 17pt} h2 {font-size: 11pt} td, th {white-space: nowrap} .note {color: #505050}"));
    document.setHtml(reportHtml(content));
    insertDrawing(document, "[mechanism]", QTextFormat::UserObject, mechanismObject);
    insertDrawing(document, "[figure]", QTextFormat::UserObject + 1, figureObject);

    const auto print = [&document](QPdfWriter &writer) { document.print(&writer); };
    return writeWhole(path, makePdf(QPageSize(QPageSize::A4), Report::tr("Motion of an offset slider-crank"), print));
}

} // namespace slidercrank

#include "moc_report.cpp"
