// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A widget that shows a page: its sentence, its findings with their buttons, and its chart and tables, side by side if
// there is space. The page is computed only while the panel is visible, at most ten times a second.

#include "ui/panels/page.h"

#include <QTimer>
#include <QWidget>

#include <chrono>
#include <functional>

class QBoxLayout;
class QLabel;
class QScrollArea;
class QToolButton;

namespace slidercrank
{

inline constexpr std::chrono::milliseconds kReadingTime{100}; ///< numbers that change faster cannot be read

class Session;

class TablePanel : public QWidget
{
    Q_OBJECT

public:
    /// `name`: the object name; `title`: what a screen reader announces.
    TablePanel(Session *session, const QString &name, const QString &title, const std::function<Page()> &makePage);

    /// Writes the tables with every digit (.csv) or the chart (.png, .svg, .pdf). Returns an error message if the file
    /// cannot be written.
    std::optional<QString> exportTo(const QString &path) const;

    QSize minimumSizeHint() const override { return {200, 100}; } ///< what does not fit scrolls

public slots:
    void refresh();

signals:
    void timeRequested(double seconds);
    void partHovered(slidercrank::MechanismPart part);
    void remedyRequested(const slidercrank::Finding &finding);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QLayout *makeHead(const QString &name);
    void prepareFindings();
    void prepareChartAndScrollArea();
    void fill();
    void fillFindings(const Page &page);
    void fillTables(const Page &page);
    NumberTable *tableFor(const PageTable &content);
    void arrange();
    void copy();
    void confirmCopied();

    Session *m_session; ///< tells the user what was copied or written
    std::function<Page()> m_makePage;
    bool m_isStale = true;
    QTimer m_pause{this}; ///< runs for a short time after each update
    std::vector<Finding> m_shownFindings;

    QLabel *m_sentence;
    QToolButton *m_copyButton;
    QToolButton *m_exportButton;
    QWidget *m_findings;
    QScrollArea *m_scrollArea;
    QBoxLayout *m_tablesLayout; ///< the tables, side by side or one above the other
    Chart *m_chart;
    std::vector<NumberTable *> m_shownTables;
    QLabel *m_note;
};

/// Adds a button to a row. `explanation`: the tool tip.
QToolButton *addButton(QBoxLayout *row, const QString &name, const QString &text, const QString &explanation);

/// Returns a button with an empty menu, which a click opens.
QToolButton *makeMenuButton(const QString &name, const QString &text, const QString &explanation);

/// Asks for a file name, calls write(path), which returns an error message if the file cannot be written, and reports
/// the outcome.
void chooseExport(Session *session, QWidget *parent, const QStringList &filters, const QString &name,
                  const std::function<std::optional<QString>(const QString &path)> &write);

/// Returns the tables of a page as CSV, one after the other. Headings that equal those of the table before are not
/// repeated.
QByteArray csvOf(const Page &page);

} // namespace slidercrank
