// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Five small charts: how stroke, time ratio, minimum transmission angle, peak slider speed and peak slider acceleration
// depend on one parameter. A dot marks the current value and can be dragged; pinned motions are additional dots.
// The curves are computed in the background, one value per pixel.

#include "ui/document/background_task.h"
#include "ui/export/figure_export.h"
#include "ui/panels/response.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace slidercrank
{

class ResponseChart;
class Session;

class ResponseView : public QWidget
{
    Q_OBJECT

public:
    explicit ResponseView(Session *session, QWidget *parent = nullptr);

    /// Shows the response to `parameter`, which must be one of kVariedParameters.
    void setParameter(Parameter parameter);

    /// Returns the curves that are displayed.
    const Response &response() const { return m_response; }

    /// Writes the charts (.png, .svg, .pdf) or the numbers of the curves (.csv), depending on the suffix. Returns an
    /// error message if the file cannot be written.
    std::optional<QString> exportTo(const QString &path) const;

signals:
    void copied(const QString &sentence);
    void problemFound(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void showResponse(bool isNew); ///< `isNew`: the curves have changed, not only the dots
    FigureDrawing drawing() const;
    void copy();

    Session *m_session;
    Response m_response;
    BackgroundTask m_task;
    QComboBox *m_parameter;
    QLabel *m_sentence;
    std::array<ResponseChart *, kLimitCount> m_charts;
};

} // namespace slidercrank
