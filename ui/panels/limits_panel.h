// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the mechanism can do and how far it goes: whether the crank turns round and why, where the slider turns back,
// how fast slider and coupler ever get. A row with an instant leads there.

#include "ui/document/result.h"

#include <QWidget>

#include <memory>
#include <vector>

class QBoxLayout;
class QLabel;
class QScrollArea;

namespace slidercrank
{

class NumberTable;
struct TableColumn;

class LimitsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LimitsPanel(QWidget *parent = nullptr);

    /// Both tables, as they are on show; a sentence when it could not be written.
    std::optional<QString> exportCsv(const QString &path);

public slots:
    /// Kept; computed and filled in when the panel is on show.
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);

signals:
    void timeRequested(double seconds); ///< somebody wants to see the mechanism there
    void rowsCopied(int count);
    void problemFound(const QString &sentence); ///< one sentence, for the message bar

protected:
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    NumberTable *createTable(const QString &name, const QString &title, std::vector<TableColumn> columns);
    QLayout *createHead(); ///< the sentence, and what can be done with the tables
    QString csv();         ///< of both tables, as the result on show has it
    void copy();
    void chooseFile();
    void showLater(); ///< m_result, at once where the panel is on show
    void fill();
    void arrange(); ///< the tables side by side where there is room, else one above the other

    std::shared_ptr<const Result> m_result;
    bool m_stale = false; ///< m_result is not on show yet
    QLabel *m_sentence = nullptr;
    QScrollArea *m_scroll = nullptr;
    QBoxLayout *m_tables = nullptr;
    NumberTable *m_positions = nullptr;
    NumberTable *m_peaks = nullptr;
};

} // namespace slidercrank
