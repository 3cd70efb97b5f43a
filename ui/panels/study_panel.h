// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Speed and accuracy: runs the study beside the window, for this mechanism or the named hard cases, and shows a case of
// it as a picture and as a table.

#include "core/study/study.h"
#include "ui/document/work_aside.h"

#include <QString>
#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSplitter;
class QToolButton;

namespace slidercrank
{

class NumberTable;
class StudyPicture;

class StudyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPanel(QWidget *parent = nullptr);

    /// Of the case on show, in light colours, by the file name's suffix; a sentence when it could not be written.
    std::optional<QString> exportPicture(const QString &path) const;

    /// Goes on with what the other shows and runs, in its place.
    void takeOver(StudyPanel &other);

    /// Every case: JSON where the name ends in .json, else CSV.
    std::optional<QString> exportNumbers(const QString &path) const;

public slots:
    void setParameters(const slidercrank::Parameters &parameters);
    void setResult(const std::shared_ptr<const slidercrank::StudyResult> &result); ///< in place of the one on show
    void runThisMechanism();
    void runHardCases();
    void cancel();

signals:
    void finished();                            ///< or cancelled
    void problemFound(const QString &sentence); ///< one sentence, for the message bar
    void rowsCopied(int count);                 ///< of the table, to the clipboard

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void run(StudyRequest request);
    void listen();
    const CaseResult *shownCase() const;
    void showCase();
    void fillTable(const CaseResult &which);
    void shareTheRoom();
    void showSummary();
    void updateButtons();
    void choosePicture();
    void chooseNumbers();
    void tellProblem(const std::optional<QString> &sentence);

    Parameters m_parameters;
    std::shared_ptr<const StudyResult> m_result;
    WorkAside *m_study; ///< a child of the panel that it tells

    QPushButton *m_runThis = nullptr;
    QPushButton *m_runHard = nullptr;
    QPushButton *m_cancel = nullptr;
    QProgressBar *m_progress = nullptr;
    QComboBox *m_cases = nullptr;
    QToolButton *m_export = nullptr;
    QLabel *m_summary = nullptr;
    QLabel *m_answer = nullptr;
    StudyPicture *m_picture = nullptr;
    NumberTable *m_table = nullptr;
    QSplitter *m_beside = nullptr;
    bool m_isSharedByHand = false;
};

} // namespace slidercrank
