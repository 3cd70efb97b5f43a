// SPDX-License-Identifier: GPL-3.0-or-later

// How the report is laid out on pages. report_text.cpp makes its text.

#include "ui/export/report.h"

#include "ui/document/whole_file.h"
#include "ui/export/polygon_figure.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QScopeGuard>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextObjectInterface>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
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

/// The sections after the section of a drawing that shall be on its page.
enum class Followers {
    None,
    NextOrAll ///< all sections to the end, if they leave enough space for the drawing; otherwise only the next one
};

/// A drawing in the text whose height depends on the space on its page.
struct FlexibleDrawing {
    DrawingObject &drawing;
    int type = 0;           ///< QTextFormat::objectType() of its place in the document
    double minHeight = 0.0; ///< px
    double maxHeight = 0.0; ///< px
    Followers followers = Followers::None;
};

/// Arranges the sections of a document on its pages.
class Pages
{
public:
    Pages(QTextDocument &document, const std::vector<FlexibleDrawing> &drawings)
        : m_document(document)
        , m_page(document.pageSize())
        , m_drawings(drawings)
        , m_heading(headingAfter(document.begin()))
    {
    }

    /// Arranges the next section. Returns false if none is left.
    bool arrangeNext()
    {
        if (!m_heading.isValid()) {
            return false;
        }
        const auto isHere = [&](const FlexibleDrawing &flexible) { return hasObject(m_heading, flexible.type); };
        const auto flexible = std::ranges::find_if(m_drawings, isHere);
        if (flexible == m_drawings.end()) {
            keepTogether(m_heading);
        } else {
            fillPage(m_heading, *flexible);
        }
        m_heading = headingAfter(m_heading);
        return true;
    }

    /// Returns the part of the document that is arranged, 0 … 1.
    double arrangedPart() const
    {
        return m_heading.isValid() ? static_cast<double>(m_heading.position()) / m_document.characterCount() : 1.0;
    }

private:
    static constexpr int kSectionLevel = 2; ///< level of the headings of sections

    /// Moves a section that a page break would divide to the next page, unless this left a large part of a page empty.
    void keepTogether(const QTextBlock &heading)
    {
        constexpr double kMaxEmptyPart = 0.4; // of a page
        const double top = boxOf(heading).top();
        const bool isDivided = pageAt(top) != pageAt(bottomOf(heading));
        const double space = m_page.height() - std::fmod(top, m_page.height()); // on the page where it begins
        if (isDivided && space < kMaxEmptyPart * m_page.height()) {
            setPageBreak(heading, QTextFormat::PageBreak_AlwaysBefore);
        }
    }

    /// Gives a drawing the height with which its section and the sections that follow it (Followers) fill a page. If
    /// the rest of the page on which the section begins has space for the drawing with its minimum height, they remain
    /// there; otherwise they begin a new page.
    void fillPage(const QTextBlock &heading, const FlexibleDrawing &flexible)
    {
        constexpr int kReservedHeight = 24; // px, because the space between paragraphs depends on the page
        const double spaceBefore = std::fmod(boxOf(heading).top(), m_page.height());
        setPageBreak(heading, QTextFormat::PageBreak_AlwaysBefore); // for the measurement
        const auto heightUntil = [&](double bottom) { return bottom - boxOf(heading).top() + kReservedHeight; };
        double occupiedHeight = heightUntil(bottomOf(heading)); // by everything except the drawing
        if (flexible.followers == Followers::NextOrAll) {
            const QTextBlock next = headingAfter(heading);
            const double withAll = heightUntil(boxOf(m_document.lastBlock()).bottom());
            const bool isSpaceForAll = m_page.height() - withAll >= flexible.minHeight;
            occupiedHeight = isSpaceForAll ? withAll : heightUntil(bottomOf(next.isValid() ? next : heading));
        }
        double space = m_page.height() - occupiedHeight;
        if (space - spaceBefore >= flexible.minHeight) {
            setPageBreak(heading, QTextFormat::PageBreak_Auto);
            space -= spaceBefore;
        }
        flexible.drawing.setHeight(static_cast<int>(std::min(flexible.maxHeight, space)));
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
    std::vector<FlexibleDrawing> m_drawings;
    QTextBlock m_heading; ///< of the section to be arranged next; invalid at the end
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
    constexpr double kSpacing = 48.0;    // px, between table and drawing
    constexpr double kMinWidth = 240.0;  // px
    constexpr double kMaxWidth = 380.0;  // px
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

/// A report that is laid out on pages of a size (px).
class LaidOutReport
{
public:
    /// The sections have to be arranged before the pages are printed.
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
        const QString html = reportHtml(content);
        setText(m_document, font, html);
        insertDrawing(m_document, kMechanismPlaceholder, kMechanismType, m_mechanism);
        insertDrawing(m_document, kPolygonsPlaceholder, kPolygonType, m_polygons);
        insertDrawing(m_document, kFigurePlaceholder, kFigureType, m_figure);
        m_document.setPageSize(page);
        const double minPolygons = minimumPolygonHeight(font);
        m_sections.emplace(
            m_document, std::vector<FlexibleDrawing>{
                            {.drawing = m_polygons,
                             .type = kPolygonType,
                             .minHeight = minPolygons,
                             .maxHeight = kMaxPolygonRatio * page.width(),
                             .followers = html.contains(kFigurePlaceholder) ? Followers::None : Followers::NextOrAll},
                            {.drawing = m_figure,
                             .type = kFigureType,
                             .minHeight = kMinFigure * page.height(),
                             .maxHeight = kMaxFigureRatio * page.width(),
                             .followers = Followers::NextOrAll}});
    }

    Pages &sections() { return *m_sections; }

    int pageCount() const { return m_document.pageCount(); }

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

    /// Prints a page, counted from 0, with its number.
    void print(QPainter &painter, int number, const QMarginsF &margins)
    {
        const QSizeF page = m_document.pageSize();
        // A line that begins exactly where the page ends belongs to the next page alone.
        const QRectF shown(0.0, number * page.height(), page.width(), page.height() - 1.0);
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
                         ReportLayout::tr("page %1 of %2").arg(number + 1).arg(pageCount()));
    }

private:
    QFont m_font;
    DrawingObject m_mechanism; ///< the drawings outlive the document, which draws them
    DrawingObject m_polygons;
    DrawingObject m_figure;
    QTextDocument m_document;
    std::optional<Pages> m_sections;
};

/// Writes a report in pieces, with the largest letters with which no line is wider than the page, or the smallest ones.
/// Slightly smaller letters are used if they save a last page with only a few lines.
class ReportPieces : public ReportExport
{
public:
    ReportPieces(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                 const FigureDrawing &figure)
        : m_path(path)
        , m_content(content)
        , m_mechanism(mechanism)
        , m_figure(figure)
    {
        m_buffer.open(QIODevice::WriteOnly);
        preparePdf(m_writer, m_paper, ReportLayout::tr("Motion of an offset slider-crank"));
    }

    bool advance() override
    {
        const auto restore = qScopeGuard([shown = notation()] { setNotation(shown); });
        setNotation(m_notation);
        switch (m_next) {
        case Piece::Text: m_next = layOut(); break;
        case Piece::Section: m_next = arrangeSection(); break;
        case Piece::Page: m_next = printPage(); break;
        case Piece::File: m_next = writeFile(); break;
        case Piece::None: break;
        }
        return m_next != Piece::None;
    }

private:
    enum class Piece { Text, Section, Page, File, None };

    static constexpr int kLargestLetters = 12; // px, 9 pt
    static constexpr int kSmallestLetters = 9;
    static constexpr double kMargin = 18.0 / kMmPerInch * kLogicalPixelsPerInch; // px
    static constexpr double kLayoutFraction = 0.6;                               // of the progress

    // Each of these functions does a piece, and returns the next one.

    Piece layOut()
    {
        constexpr double kFooter = 18.0; // px, above the lower margin
        const QSizeF page = m_paper.size(QPageSize::Point) * (kLogicalPixelsPerInch / kPointsPerInch);
        const QSizeF text(page.width() - 2.0 * kMargin, page.height() - 2.0 * kMargin - kFooter);
        m_report = std::make_unique<LaidOutReport>(m_content, letterFont(m_letters), text, m_mechanism, m_figure);
        return Piece::Section;
    }

    Piece arrangeSection()
    {
        const bool hasArranged = m_report->sections().arrangeNext();
        m_progress = std::max(m_progress, kLayoutFraction * m_report->sections().arrangedPart());
        return hasArranged ? Piece::Section : chooseLetters();
    }

    /// Accepts the letters, or tries smaller ones.
    Piece chooseLetters()
    {
        if (m_larger) { // the smaller letters were tried to save a page
            if (m_report->endsWithFewLines()) {
                m_report = std::move(m_larger);
            }
            return Piece::Page;
        }
        if (m_letters == kSmallestLetters || (m_report->fitsWidth() && !m_report->endsWithFewLines())) {
            return Piece::Page;
        }
        if (m_report->fitsWidth()) {
            m_larger = std::move(m_report);
        }
        --m_letters;
        return Piece::Text;
    }

    Piece printPage()
    {
        if (m_page == 0) {
            m_painter.begin(&m_writer);
        } else {
            m_writer.newPage();
        }
        m_report->print(m_painter, m_page, {kMargin, kMargin, kMargin, kMargin});
        ++m_page;
        m_progress = kLayoutFraction + (1.0 - kLayoutFraction) * m_page / (m_report->pageCount() + 1);
        return m_page < m_report->pageCount() ? Piece::Page : Piece::File;
    }

    Piece writeFile()
    {
        m_painter.end();
        m_problem = writeWhole(m_path, m_buffer.data());
        m_progress = 1.0;
        return Piece::None;
    }

    QString m_path;
    ReportContent m_content;
    FigureDrawing m_mechanism;
    FigureDrawing m_figure;
    Notation m_notation = notation();
    QPageSize m_paper{m_content.paper == PaperSize::A4 ? QPageSize::A4 : QPageSize::Letter};
    Piece m_next = Piece::Text;
    int m_letters = kLargestLetters;
    std::unique_ptr<LaidOutReport> m_report;
    std::unique_ptr<LaidOutReport> m_larger; ///< with larger letters, but with a last page that has only a few lines
    int m_page = 0;                          ///< to be printed next
    QBuffer m_buffer;
    QPdfWriter m_writer{&m_buffer};
    QPainter m_painter; ///< the last member, since it draws until it is destroyed
};

} // namespace

PaperSize usualPaper()
{
    return QLocale().measurementSystem() == QLocale::ImperialUSSystem ? PaperSize::Letter : PaperSize::A4;
}

std::shared_ptr<ReportExport> beginReport(const QString &path, const ReportContent &content,
                                          const FigureDrawing &mechanism, const FigureDrawing &figure)
{
    return std::make_shared<ReportPieces>(path, content, mechanism, figure);
}

std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure)
{
    const std::shared_ptr<ReportExport> report = beginReport(path, content, mechanism, figure);
    while (report->advance()) {
    }
    return report->problem();
}

} // namespace slidercrank

#include "report.moc"
