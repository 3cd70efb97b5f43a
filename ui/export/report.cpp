// SPDX-License-Identifier: GPL-3.0-or-later

// How the report is laid out on pages. report_text.cpp makes its text.

#include "ui/export/report.h"

#include "ui/document/whole_file.h"
#include "ui/export/polygon_figure.h"
#include "ui/text/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextObjectInterface>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

struct ReportLayout {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReportLayout)
};

/// Draws vector graphics within the text.
class DrawingObject : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    DrawingObject(const FigureDrawing &draw, const QFont &font, const QSize &size)
        : m_draw(draw)
        , m_font(font)
        , m_size(size)
    {
    }

    void setHeight(int height) { m_size.setHeight(height); } ///< px

    QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &) override { return m_size; }
    void drawObject(QPainter *painter, const QRectF &box, QTextDocument *, int, const QTextFormat &) override
    {
        painter->save();
        painter->translate(box.topLeft());
        painter->setFont(m_font);
        m_draw(*painter, m_size);
        painter->restore();
    }

private:
    FigureDrawing m_draw;
    QFont m_font;
    QSize m_size;
};

void insertDrawing(QTextDocument &document, const QString &placeholder, int type, DrawingObject &drawing)
{
    document.documentLayout()->registerHandler(type, &drawing);
    QTextCharFormat format;
    format.setObjectType(type);
    if (QTextCursor place = document.find(placeholder); !place.isNull()) { // not every report has every drawing
        place.insertText(QString(QChar::ObjectReplacementCharacter), format);
    }
}

/// The sections that stand on the same page as a drawing.
enum class Followers {
    None,     ///< only the section of the drawing
    NextOrAll ///< all sections after it, if they leave enough space for the drawing; otherwise only the next one
};

/// A drawing in the text whose height depends on the space on its page.
struct FlexibleDrawing {
    DrawingObject &drawing;
    int type = 0;          ///< object type in the document
    double smallest = 0.0; ///< height, px
    double largest = 0.0;
    Followers followers = Followers::None;
};

/// Arranges the sections of a document on its pages.
class Pages
{
public:
    explicit Pages(QTextDocument &document)
        : m_document(document)
        , m_page(document.pageSize())
    {
    }

    /// Arranges all sections, in their order.
    void arrange(const std::vector<FlexibleDrawing> &drawings)
    {
        QTextBlock heading = headingAfter(m_document.begin());
        for (; heading.isValid(); heading = headingAfter(heading)) {
            const auto isHere = [&](const FlexibleDrawing &flexible) { return hasObject(heading, flexible.type); };
            const auto flexible = std::ranges::find_if(drawings, isHere);
            if (flexible == drawings.end()) {
                keepTogether(heading);
            } else {
                fillPage(heading, *flexible);
            }
        }
    }

private:
    static constexpr int kSectionLevel = 2; ///< level of the headings of sections

    /// Moves a section that a page break would divide to the next page, if it fits on a page.
    void keepTogether(const QTextBlock &heading)
    {
        const double top = boxOf(heading).top();
        const double bottom = bottomOf(heading);
        const bool isDivided = pageAt(top) != pageAt(bottom);
        if (isDivided && bottom - top <= m_page.height() && std::fmod(top, m_page.height()) > 0.0) {
            setPageBreak(heading, QTextFormat::PageBreak_AlwaysBefore);
        }
    }

    /// Gives a drawing the height with which its section and the followers fill the page. They stand on a new page,
    /// unless the drawing can have the smallest height on the page on which they begin.
    void fillPage(const QTextBlock &heading, const FlexibleDrawing &flexible)
    {
        constexpr int kReservedHeight = 24; // px, because the space between paragraphs depends on the page
        const double spaceBefore = std::fmod(boxOf(heading).top(), m_page.height());
        setPageBreak(heading, QTextFormat::PageBreak_AlwaysBefore); // for the measurement
        const auto heightUntil = [&](double bottom) { return bottom - boxOf(heading).top() + kReservedHeight; };
        double others = heightUntil(bottomOf(heading));
        if (flexible.followers == Followers::NextOrAll) {
            const QTextBlock next = headingAfter(heading);
            const double withAll = heightUntil(boxOf(m_document.lastBlock()).bottom());
            const bool isSpaceForAll = m_page.height() - withAll >= flexible.smallest;
            others = isSpaceForAll ? withAll : heightUntil(bottomOf(next.isValid() ? next : heading));
        }
        double space = m_page.height() - others;
        if (space - spaceBefore >= flexible.smallest) {
            setPageBreak(heading, QTextFormat::PageBreak_Auto);
            space -= spaceBefore;
        }
        flexible.drawing.setHeight(static_cast<int>(std::min(flexible.largest, space)));
        layOut();
    }

    void setPageBreak(const QTextBlock &heading, QTextFormat::PageBreakFlag policy)
    {
        QTextCursor cursor(heading);
        QTextBlockFormat format = heading.blockFormat();
        format.setPageBreakPolicy(policy);
        cursor.setBlockFormat(format);
        layOut();
    }

    void layOut() { m_document.markContentsDirty(0, m_document.characterCount()); }
    QRectF boxOf(const QTextBlock &block) const { return m_document.documentLayout()->blockBoundingRect(block); }
    int pageAt(double y) const { return static_cast<int>(y / m_page.height()); }

    /// Returns whether a section contains an object of that type.
    static bool hasObject(const QTextBlock &heading, int type)
    {
        const QTextBlock end = headingAfter(heading);
        for (QTextBlock block = heading; block != end; block = block.next()) {
            for (auto fragment = block.begin(); !fragment.atEnd(); ++fragment) {
                if (fragment.fragment().charFormat().objectType() == type) {
                    return true;
                }
            }
        }
        return false;
    }

    static QTextBlock headingAfter(QTextBlock block)
    {
        do {
            block = block.next();
        } while (block.isValid() && block.blockFormat().headingLevel() != kSectionLevel);
        return block;
    }

    /// Returns the lower end of a section.
    double bottomOf(const QTextBlock &heading) const
    {
        double bottom = boxOf(heading).bottom();
        const QTextBlock end = headingAfter(heading);
        for (QTextBlock block = heading.next(); block.isValid() && block != end; block = block.next()) {
            bottom = std::max(bottom, boxOf(block).bottom());
        }
        return bottom;
    }

    QTextDocument &m_document;
    QSizeF m_page;
};

QFont letterFont(int pixels)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(pixels);
    font.setHintingPreference(QFont::PreferNoHinting); // the spacing of letters is that of the printer
    return font;
}

const QString kStyle =
    "h1 {font-size: x-large; margin-bottom: 2px} h2 {font-size: large; margin-top: 12px; margin-bottom: 4px} "
    "p {margin-top: 4px; margin-bottom: 4px} th, td {padding-right: 10px} td.unbroken {white-space: nowrap} "
    ".note {color: #505050} .dense td, .dense th {font-size: small; padding-right: 4px} "
    ".numbers td, .numbers th {padding-right: 6px; white-space: nowrap}";

void setText(QTextDocument &document, const QFont &font, const QString &html)
{
    document.setDefaultFont(font);
    document.setDefaultStyleSheet(kStyle);
    document.setDocumentMargin(0.0);
    document.setHtml(html);
}

/// Returns the size (px) of the mechanism's drawing beside the table of the parameters.
QSize drawingSize(const ReportContent &content, const QFont &font, double textWidth)
{
    constexpr double kSpacing = 48.0; // px, between table and drawing
    constexpr double kMinWidth = 240.0;
    constexpr double kMaxWidth = 380.0;
    constexpr double kHeightRatio = 0.6; // height of the drawing over its width
    QTextDocument table;
    setText(table, font, parameterTable(content));
    const double width = std::clamp(textWidth - table.idealWidth() - kSpacing, kMinWidth, kMaxWidth);
    return {static_cast<int>(width), static_cast<int>(kHeightRatio * width)};
}

FigureDrawing polygonDrawing(const ReportContent &content)
{
    return [polygons = polygonsAt(content.result->mechanism, content.time, content.alpha2)](QPainter &painter,
                                                                                            const QSize &size) {
        painter.setRenderHint(QPainter::Antialiasing);
        drawPolygons(painter, QRectF({0.0, 0.0}, QSizeF(size)), polygons, paletteFor(Theme::Light));
    };
}

/// A report laid out on pages of a size (px).
class LaidOutReport
{
public:
    LaidOutReport(const ReportContent &content, const QFont &font, const QSizeF &page, const FigureDrawing &mechanism,
                  const FigureDrawing &figure)
        : m_font(font)
        , m_mechanism(mechanism, font, drawingSize(content, font, page.width()))
        , m_polygons(polygonDrawing(content), font, {static_cast<int>(page.width()), 1})
        , m_figure(figure, font, {static_cast<int>(page.width()), 1})
    {
        constexpr double kMaxPolygonRatio = 0.75; // height over width
        constexpr double kMaxFigureRatio = 1.4;
        constexpr double kMinFigure = 0.45; // of the page
        constexpr int kMechanismType = QTextFormat::UserObject;
        constexpr int kPolygonType = QTextFormat::UserObject + 1;
        constexpr int kFigureType = QTextFormat::UserObject + 2;
        setText(m_document, font, reportHtml(content));
        insertDrawing(m_document, kMechanismPlace, kMechanismType, m_mechanism);
        insertDrawing(m_document, kPolygonsPlace, kPolygonType, m_polygons);
        insertDrawing(m_document, kFigurePlace, kFigureType, m_figure);
        m_document.setPageSize(page);
        const double minPolygons = minimumPolygonHeight(font);
        Pages(m_document)
            .arrange({{.drawing = m_polygons,
                       .type = kPolygonType,
                       .smallest = minPolygons,
                       .largest = kMaxPolygonRatio * page.width(),
                       .followers = Followers::None},
                      {.drawing = m_figure,
                       .type = kFigureType,
                       .smallest = kMinFigure * page.height(),
                       .largest = kMaxFigureRatio * page.width(),
                       .followers = Followers::NextOrAll}});
    }

    /// Returns whether no line is wider than the page.
    bool fitsWidth() const
    {
        constexpr double kRounding = 0.5; // px
        return m_document.size().width() <= m_document.pageSize().width() + kRounding;
    }

    /// Returns whether the last page has only a few lines.
    bool endsWithFewLines() const
    {
        constexpr double kMinLastPage = 0.1; // fraction of the page
        const double page = m_document.pageSize().height();
        const double end = m_document.documentLayout()->blockBoundingRect(m_document.lastBlock()).bottom();
        return m_document.pageCount() > 1 && end - (m_document.pageCount() - 1) * page < kMinLastPage * page;
    }

    /// Prints the pages with their numbers.
    void print(QPdfWriter &writer, const QMarginsF &margins)
    {
        QPainter painter(&writer);
        const QSizeF page = m_document.pageSize();
        const int count = m_document.pageCount();
        for (int i = 0; i < count; ++i) {
            if (i > 0) {
                writer.newPage();
            }
            // A line that begins exactly where the page ends belongs to the next page alone.
            const QRectF shown(0.0, i * page.height(), page.width(), page.height() - 1.0);
            painter.save();
            painter.translate(margins.left(), margins.top() - shown.top());
            painter.setClipRect(shown);
            QAbstractTextDocumentLayout::PaintContext context;
            context.clip = shown;
            context.palette.setColor(QPalette::Text, Qt::black);
            m_document.documentLayout()->draw(&painter, context);
            painter.restore();
            const QRectF footer(margins.left(), margins.top() + page.height(), page.width(), margins.bottom());
            painter.setFont(m_font);
            painter.setPen(QColor(0x50, 0x50, 0x50));
            painter.drawText(footer, Qt::AlignRight | Qt::AlignTop,
                             ReportLayout::tr("page %1 of %2").arg(i + 1).arg(count));
        }
    }

private:
    QFont m_font;
    DrawingObject m_mechanism; ///< the drawings outlive the document, which draws them
    DrawingObject m_polygons;
    DrawingObject m_figure;
    QTextDocument m_document;
};

using LayOut = std::function<std::unique_ptr<LaidOutReport>(int letters)>;

/// Returns the report with the largest letters with which no line is wider than the page, or with the smallest ones.
/// Slightly smaller letters than these are chosen if they save a last page with only a few lines.
std::unique_ptr<LaidOutReport> largestFittingReport(const LayOut &layOut)
{
    constexpr int kLargestLetters = 12; // px, 9 pt
    constexpr int kSmallestLetters = 9;
    int letters = kLargestLetters;
    std::unique_ptr<LaidOutReport> report = layOut(letters);
    while (letters > kSmallestLetters && !report->fitsWidth()) {
        report = layOut(--letters);
    }
    if (letters > kSmallestLetters && report->endsWithFewLines()) {
        std::unique_ptr<LaidOutReport> smaller = layOut(letters - 1);
        return smaller->endsWithFewLines() ? std::move(report) : std::move(smaller);
    }
    return report;
}

} // namespace

PaperSize usualPaper()
{
    return QLocale().measurementSystem() == QLocale::ImperialUSSystem ? PaperSize::Letter : PaperSize::A4;
}

std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure)
{
    constexpr double kMargin = 18.0 / kMmPerInch * kDotsPerInch; // px
    constexpr double kFooter = 18.0;                             // px, above the lower margin
    const QPageSize paper(content.paper == PaperSize::A4 ? QPageSize::A4 : QPageSize::Letter);
    const QSizeF page = paper.size(QPageSize::Point) * (kDotsPerInch / kPointsPerInch);
    const QMarginsF margins(kMargin, kMargin, kMargin, kMargin);
    const QSizeF text(page.width() - 2.0 * kMargin, page.height() - 2.0 * kMargin - kFooter);
    const auto layOut = [&](int letters) {
        return std::make_unique<LaidOutReport>(content, letterFont(letters), text, mechanism, figure);
    };
    const auto fill = [&](QPdfWriter &writer) {
        writer.setPageMargins(QMarginsF());
        largestFittingReport(layOut)->print(writer, margins);
    };
    return writeWhole(path, makePdf(paper, ReportLayout::tr("Motion of an offset slider-crank"), fill));
}

} // namespace slidercrank

#include "report.moc"
