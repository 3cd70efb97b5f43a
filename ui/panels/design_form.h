// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A form that designs a mechanism for a given stroke and time ratio. The slider changes the ratio b/a, with the stroke
// and the time ratio fixed. Every change sets a, b and c in one edit.

#include "core/limits/design.h"
#include "ui/document/result.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class NumberSlider;

class DesignForm : public QWidget
{
    Q_OBJECT

public:
    explicit DesignForm(QWidget *parent = nullptr);

    void setResult(const Result &result);

signals:
    void edited(const slidercrank::Parameters &parameters);
    void dragBegan();
    void dragEnded();

private:
    void requestStroke(double stroke);
    void requestTimeRatio(double timeRatio);
    void requestTransmissionAngle(double degrees);
    void requestDesign(const DesignRequest &request);
    void apply(const Lengths &lengths);
    void refuse(const QString &sentence);
    void showWanted();

    Parameters m_parameters;
    DesignRequest m_wanted; ///< its time ratio is below 1 if c < 0; its stroke is 0 until a result is set
    MotionLimits m_limits;
    NumberBox *m_stroke;
    NumberBox *m_timeRatio;
    NumberBox *m_transmissionAngle;
    NumberSlider *m_ratio;
    QToolButton *m_best;
    QLabel *m_lengths;
    QLabel *m_refusal;
};

} // namespace slidercrank
