// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The dialog that asks for the size and the content of an exported figure, and shows the figure as it will be. The
// choices are stored for the next time.

#include "ui/document/view_settings.h"
#include "ui/export/figure_export.h"

#include <QDialog>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace slidercrank
{

class NumberBox;

/// A figure that can be exported.
struct FigureSubject {
    QString name;                      ///< proposed file name
    std::vector<NamedPlot> plots = {}; ///< the plots that can be chosen
    bool hasCursor = false;            ///< whether the figure can show the values at the current time
    std::function<FigureHeight(const FigureOptions &)> height;
    std::function<FigureDrawing(const FigureOptions &)> draw;
};

/// Return and store the options that were chosen last.
FigureOptions storedFigureOptions();
void storeFigureOptions(const FigureOptions &options);

/// Export or draw the figure of a subject, like the functions of the same names in figure_export.h.
std::optional<QString> exportFigure(const QString &path, const FigureSubject &subject, const FigureOptions &options);
FigureWriter drawFigure(const QString &path, const FigureSubject &subject, const FigureOptions &options);

/// Opens the dialog, and then the one for the name of the file. `write` is called when both have been accepted.
void chooseFigure(QWidget *parent, const FigureSubject &subject,
                  const std::function<void(const FigureOptions &, const QString &path)> &write);

class FigureForm : public QDialog
{
    Q_OBJECT

public:
    FigureForm(const FigureSubject &subject, const FigureOptions &options, QWidget *parent);

    FigureOptions options() const;

private:
    void prepareFields(const FigureOptions &options);
    QLayout *makeForm();
    void fitPreview(const QSize &occupied);
    QLayout *makePlotBoxes(const FigureOptions &options);
    void limitWidth();
    void changeUnit();
    void showPreview();

    FigureSubject m_subject;
    NumberBox *m_width;
    QComboBox *m_unit;
    NumberBox *m_fontSize;
    QComboBox *m_format;
    QCheckBox *m_cursor;
    std::vector<QCheckBox *> m_plots;
    QLabel *m_preview;
    QLabel *m_summary;
    QPushButton *m_export;
};

} // namespace slidercrank
