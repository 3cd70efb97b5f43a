// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_pages.h"

#include "ui/document/whole_file.h"
#include "ui/text/theme.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextOption>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

struct ReportPages {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReportPages)
};

using Kind = ReportBlock::Kind;

// In logical pixels, as everywhere in drawings; A4 is 794 x 1123 of them.
constexpr double kMargin = 60.0;
constexpr double kFooter = 24.0;
constexpr double kGap = 7.0;           // between blocks
constexpr double kGapOfHeading = 16.0; // above one
constexpr double kCellGap = 8.0;       // between columns
constexpr double kRowGap = 5.0;        // within a row, above and below together
constexpr double kDrawingHeight = 200.0;
constexpr double kDrawingGap = 24.0;

/// The nine plots are laid out for this width and brought to the page's.
constexpr double kFigureWidth = 900.0;
/// A figure that is less high than this goes to a page of its own.
constexpr double kLeastFigureHeight = 700.0;

QFont fontOf(Kind kind)
{
    QFont font = QGuiApplication::font();
    font.setBold(false);
    // Any spacing at all, however small, keeps letters from being joined: who searches for "file" would not find it.
    constexpr double kUnseen = 0.02; // px
    font.setLetterSpacing(QFont::AbsoluteSpacing, kUnseen);
    switch (kind) {
    case Kind::Title:
        font.setPixelSize(24);
        font.setBold(true);
        break;
    case Kind::Heading:
        font.setPixelSize(15);
        font.setBold(true);
        break;
    case Kind::Agreement:
    case Kind::Difference:
        font.setPixelSize(13);
        font.setBold(true);
        break;
    case Kind::Text: font.setPixelSize(12); break;
    case Kind::Note:
    case Kind::Mechanism:
    case Kind::Figure: font.setPixelSize(11); break;
    case Kind::Table: font.setPixelSize(10); break; // nine columns
    }
    return font;
}

QColor colourOf(Kind kind, const SeriesColours &colours)
{
    switch (kind) {
    case Kind::Agreement: return colours.errorOther;
    case Kind::Difference: return colours.warning;
    case Kind::Note: return QColor(0x50, 0x50, 0x50);
    case Kind::Title:
    case Kind::Heading:
    case Kind::Text:
    case Kind::Table:
    case Kind::Mechanism:
    case Kind::Figure: break;
    }
    return colours.text;
}

/// No line ends between a number and its sign of per cent, nor behind a sign of comparison.
QString unbroken(QString text)
{
    const QChar space(QChar::Nbsp);
    return text.replace(QStringLiteral(" %"), space + QStringLiteral("%"))
        .replace(QStringLiteral(" ≤ "), space + QStringLiteral("≤") + space);
}

/// A table laid out for a width: what does not fit there is broken within the last column.
class TableLayout
{
public:
    TableLayout(const ReportTable &table, const QFont &font, double width)
        : m_table(table)
        , m_font(font)
        , m_headerFont(m_font)
    {
        m_headerFont.setBold(true);
        const QFontMetricsF metrics(m_font);
        const QFontMetricsF headerMetrics(m_headerFont);
        for (qsizetype column = 0; column < table.header.size(); ++column) {
            double needed = headerMetrics.horizontalAdvance(table.header[column]);
            for (const QStringList &row : table.rows) {
                needed = std::max(needed, metrics.horizontalAdvance(row[column]));
            }
            const bool isLast = column + 1 == table.header.size();
            m_widths.push_back(std::ceil(needed) + (isLast ? 0.0 : kCellGap));
        }
        const double others = std::accumulate(m_widths.begin(), m_widths.end() - 1, 0.0);
        constexpr double kLeastWidth = 40.0;
        m_widths.back() = std::min(m_widths.back(), std::max(width - others, kLeastWidth));
    }

    double width() const { return std::accumulate(m_widths.begin(), m_widths.end(), 0.0); }
    double headerHeight() const { return heightOf(m_table.header, m_headerFont); }
    double rowHeight(std::size_t row) const { return heightOf(m_table.rows[row], m_font); }

    double height() const
    {
        double height = headerHeight();
        for (std::size_t row = 0; row < m_table.rows.size(); ++row) {
            height += rowHeight(row);
        }
        return height;
    }

    void paintHeader(QPainter &painter, const QPointF &at) const { paint(painter, at, m_table.header, m_headerFont); }
    void paintRow(QPainter &painter, const QPointF &at, std::size_t row) const
    {
        paint(painter, at, m_table.rows[row], m_font);
    }

private:
    int alignment(qsizetype column) const
    {
        const Qt::Alignment side = m_table.numeric[column] == u'n' ? Qt::AlignRight : Qt::AlignLeft;
        return static_cast<int>(side | Qt::AlignTop) | Qt::TextWordWrap;
    }

    double cellWidth(qsizetype column) const
    {
        const auto index = static_cast<std::size_t>(column);
        return m_widths[index] - (index + 1 < m_widths.size() ? kCellGap : 0.0);
    }

    double heightOf(const QStringList &cells, const QFont &font) const
    {
        const QFontMetricsF metrics(font);
        double height = metrics.height();
        for (qsizetype column = 0; column < cells.size(); ++column) {
            const QRectF room(0.0, 0.0, cellWidth(column) + 1.0, 1e6);
            height = std::max(height, metrics.boundingRect(room, alignment(column), cells[column]).height());
        }
        return std::ceil(height) + kRowGap;
    }

    void paint(QPainter &painter, QPointF at, const QStringList &cells, const QFont &font) const
    {
        painter.setFont(font);
        const double height = heightOf(cells, font);
        for (qsizetype column = 0; column < cells.size(); ++column) {
            painter.drawText(QRectF(at.x(), at.y() + 0.5 * kRowGap, cellWidth(column) + 1.0, height), alignment(column),
                             cells[column]);
            at.rx() += m_widths[static_cast<std::size_t>(column)];
        }
    }

    const ReportTable &m_table;
    QFont m_font;
    QFont m_headerFont;
    std::vector<double> m_widths;
};

/// Puts block after block on the pages of a writer.
class Pages
{
public:
    Pages(QPdfWriter &writer, QPainter &painter, const ReportDrawings &drawings, const QString &footer)
        : m_writer(writer)
        , m_painter(painter)
        , m_drawings(drawings)
        , m_footer(footer)
        , m_colours(seriesColours(paletteFor(Theme::Light)))
        , m_page(0.0, 0.0, writer.width(), writer.height())
        , m_y(kMargin)
    {
    }

    void put(const std::vector<ReportBlock> &blocks)
    {
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const double followed = i + 1 < blocks.size() ? leastHeight(blocks[i + 1]) : 0.0;
            put(blocks[i], followed);
        }
        paintFooter();
    }

private:
    double width() const { return m_page.width() - 2.0 * kMargin; }
    double bottom() const { return m_page.height() - kMargin - kFooter; }
    double textHeight(const ReportBlock &block) const
    {
        m_painter.setFont(fontOf(block.kind));
        return m_painter.boundingRect(QRectF(0.0, 0.0, width(), 1e6), unbroken(block.text), wrapping()).height();
    }

    /// Between words; a path that is longer than a line, anywhere.
    static QTextOption wrapping()
    {
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        return option;
    }

    /// What of a block has to stay together with a heading before it.
    double leastHeight(const ReportBlock &block) const
    {
        switch (block.kind) {
        case Kind::Mechanism: return drawingBlockHeight(block);
        case Kind::Table: {
            const TableLayout layout(block.table, fontOf(block.kind), width());
            return layout.headerHeight() + (block.table.rows.empty() ? 0.0 : layout.rowHeight(0));
        }
        case Kind::Figure: return kLeastFigureHeight;
        case Kind::Title:
        case Kind::Heading:
        case Kind::Text:
        case Kind::Agreement:
        case Kind::Difference:
        case Kind::Note: break;
        }
        return textHeight(block);
    }

    void need(double height)
    {
        if (m_y + height > bottom() && m_y > kMargin) {
            turnPage();
        }
    }

    void turnPage()
    {
        paintFooter();
        m_writer.newPage();
        ++m_number;
        m_y = kMargin;
    }

    void paintFooter()
    {
        m_painter.setFont(fontOf(Kind::Note));
        m_painter.setPen(colourOf(Kind::Note, m_colours));
        const QRectF line(kMargin, m_page.height() - kMargin - 0.5 * kFooter, width(), kFooter);
        const QString number = QString::number(m_number);
        const QFontMetricsF metrics(m_painter.font());
        const double room = width() - metrics.horizontalAdvance(number) - kCellGap;
        m_painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(m_footer, Qt::ElideMiddle, room));
        m_painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, number);
    }

    void put(const ReportBlock &block, double followed)
    {
        switch (block.kind) {
        case Kind::Heading:
            if (m_y > kMargin) {
                m_y += kGapOfHeading;
            }
            need(textHeight(block) + kGap + followed);
            putText(block);
            return;
        case Kind::Title:
        case Kind::Text:
        case Kind::Agreement:
        case Kind::Difference:
        case Kind::Note: putText(block); return;
        case Kind::Table: putTable(block.table, fontOf(block.kind)); return;
        case Kind::Mechanism: putMechanism(block); return;
        case Kind::Figure: putFigure(); return;
        }
    }

    void putText(const ReportBlock &block)
    {
        const double height = textHeight(block);
        need(height);
        m_painter.setFont(fontOf(block.kind));
        m_painter.setPen(colourOf(block.kind, m_colours));
        m_painter.drawText(QRectF(kMargin, m_y, width(), height + 1.0), unbroken(block.text), wrapping());
        m_y += height + kGap;
    }

    void rule(double from, double to)
    {
        m_painter.setPen(QPen(m_colours.grid, 1.0));
        m_painter.drawLine(QPointF(from, m_y), QPointF(to, m_y));
    }

    void putHeader(const TableLayout &layout)
    {
        m_painter.setPen(m_colours.text);
        layout.paintHeader(m_painter, {kMargin, m_y});
        m_y += layout.headerHeight();
        rule(kMargin, kMargin + layout.width());
    }

    void putTable(const ReportTable &table, const QFont &font)
    {
        const TableLayout layout(table, font, width());
        need(layout.headerHeight() + (table.rows.empty() ? 0.0 : layout.rowHeight(0)));
        putHeader(layout);
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            if (m_y + layout.rowHeight(row) > bottom()) {
                turnPage();
                putHeader(layout);
            }
            m_painter.setPen(m_colours.text);
            layout.paintRow(m_painter, {kMargin, m_y}, row);
            m_y += layout.rowHeight(row);
        }
        m_y += kGap;
    }

    double drawingBlockHeight(const ReportBlock &block) const
    {
        const double caption = block.text.isEmpty() ? 0.0 : kGap + QFontMetricsF(fontOf(Kind::Note)).height();
        return std::max(kDrawingHeight + caption, TableLayout(block.table, fontOf(block.kind), width()).height());
    }

    void putMechanism(const ReportBlock &block)
    {
        const TableLayout layout(block.table, fontOf(block.kind), width());
        const double height = drawingBlockHeight(block);
        need(height);
        const double top = m_y;
        putTable(block.table, fontOf(block.kind));
        const double left = kMargin + layout.width() + kDrawingGap;
        const QRectF place(left, top, m_page.width() - kMargin - left, kDrawingHeight);
        putDrawing(m_drawings.mechanism, place, 1.0);
        m_painter.setFont(fontOf(Kind::Note));
        m_painter.setPen(colourOf(Kind::Note, m_colours));
        m_painter.drawText(place.translated(0.0, kDrawingHeight + kGap), Qt::AlignHCenter | Qt::AlignTop, block.text);
        m_y = top + height + kGap;
    }

    void putFigure()
    {
        if (bottom() - m_y < kLeastFigureHeight) {
            turnPage();
        }
        putDrawing(m_drawings.figure, QRectF(kMargin, m_y, width(), bottom() - m_y), width() / kFigureWidth);
        m_y = bottom();
    }

    void putDrawing(const FigureDrawing &draw, const QRectF &place, double scale)
    {
        m_painter.save();
        m_painter.translate(place.topLeft());
        m_painter.scale(scale, scale);
        draw(m_painter, (place.size() / scale).toSize());
        m_painter.restore();
    }

    QPdfWriter &m_writer;
    QPainter &m_painter;
    const ReportDrawings &m_drawings;
    QString m_footer;
    SeriesColours m_colours;
    QRectF m_page;
    double m_y;
    int m_number = 1;
};

QString footerOf(const Result &result)
{
    const QString program = QCoreApplication::applicationName() + u' ' + QCoreApplication::applicationVersion();
    return result.reference ? ReportPages::tr("%1 · %2").arg(program, result.reference->name) : program;
}

} // namespace

std::optional<QString> exportReport(const QString &path, const ReportContent &content, const ReportDrawings &drawings)
{
    const std::vector<ReportBlock> blocks = reportOf(content);
    QBuffer pdf; // the writer does not tell when a file takes no more
    pdf.open(QIODevice::WriteOnly);
    QPdfWriter writer(&pdf);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(blocks.front().text);
    writer.setCreator(QCoreApplication::applicationName());
    QPainter painter(&writer);
    Pages(writer, painter, drawings, footerOf(*content.result)).put(blocks);
    painter.end();
    const std::optional<QString> reason = writeWhole(path, pdf.data());
    return reason ? std::optional(
                        ReportPages::tr("%1 cannot be written: %2.").arg(QDir::toNativeSeparators(path), *reason))
                  : std::nullopt;
}

} // namespace slidercrank
