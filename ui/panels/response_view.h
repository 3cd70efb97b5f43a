// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Five small charts: how stroke, time ratio, minimum transmission angle, peak slider speed and peak slider acceleration
// depend on one parameter. A dot marks the present value and can be dragged; pinned motions are further dots. The
// curves are computed at the pixels, in the background.

#include "ui/document/result.h"
#include "ui/document/background_task.h"
#include "ui/panels/response.h"

#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;

namespace slidercrank
{

class ResponseChart;

class ResponseView : public QWidget
{
    Q_OBJECT

public:
    explicit ResponseView(QWidget *parent = nullptr);

    void setResult(const std::shared_ptr<const Result> &result);

    /// One of kVariedParameters.
    void setParameter(Parameter parameter);

    /// The curves on show.
    const Response &response() const { return m_response; }

    /// The charts by the suffix (.png, .svg, .pdf) or the numbers of the curves (.csv). A sentence if it could not be
    /// written.
    std::optional<QString> exportTo(const QString &path) const;

    QSize minimumSizeHint() const override { return {200, 100}; } ///< the rest scrolls

signals:
    void parameterRequested(slidercrank::Parameter parameter, double value);
    void dragBegan();
    void dragEnded();
    void copied(const QString &sentence);
    void problemFound(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void showResponse(bool isNew); ///< else only the dots have moved
    void paint(QPainter &painter, const QSize &size) const;
    QByteArray csv() const;
    void copy();
    void chooseFile();

    std::shared_ptr<const Result> m_result;
    Response m_response;
    BackgroundTask m_work;
    bool m_isOutdated = false; ///< something changed while the curves were being computed
    QComboBox *m_parameter;
    QLabel *m_sentence;
    std::array<ResponseChart *, kLimitCount> m_charts;
};

} // namespace slidercrank
