// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Five small charts: how stroke, time ratio, minimum transmission angle, peak slider speed and peak slider acceleration
// depend on one parameter. A dot marks the current value and can be dragged; pinned motions are additional dots.
// The curves are computed in the background, one value per pixel.

#include "ui/document/background_task.h"
#include "ui/export/figure_form.h"
#include "ui/panels/response.h"
#include "ui/plots/chart.h"

class QComboBox;
class QLabel;
class QMenu;

namespace slidercrank
{

class Session;

class ResponseView : public QWidget
{
    Q_OBJECT

public:
    explicit ResponseView(Session *session, QWidget *parent = nullptr);

    /// Shows the response to `parameter`, which must be one of kVariedParameters.
    void setParameter(Parameter parameter);

    const Response &response() const { return m_response; }

    /// The series of each chart: a curve and dots.
    enum Series : std::size_t { Curve, Pinned, Present };

    /// Returns the charts as a figure with the parameters.
    FigureSubject figure() const;

    /// Writes the numbers of the curves as CSV. Returns an error message if the file cannot be written.
    std::optional<QString> exportTo(const QString &path) const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void showResponse();
    ChartContent chartOf(std::size_t limit) const;
    void setParameterAt(Chart &chart, double pixel);
    void fillExportMenu(QMenu *menu);
    void draw(QPainter &painter, const QSize &size) const;
    QString pinnedNote() const;
    void copy();

    Session *m_session;
    Response m_response;
    BackgroundTask m_task;
    QComboBox *m_parameter;
    QLabel *m_sentence;
    std::array<Chart *, kResponseLimits.size()> m_charts;
    std::array<QLabel *, kResponseLimits.size()> m_titles; ///< name and current value of each limit
};

} // namespace slidercrank
