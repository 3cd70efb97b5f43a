// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A form that designs a mechanism for a given stroke and time ratio. The slider changes the ratio b/a, with the stroke
// and the time ratio fixed. If "keep a and b" is checked, a time ratio changes the offset c alone. Every change sets a,
// b and c in one edit.

#include "core/limits/design.h"
#include "core/mechanism/mechanism.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class NumberSlider;
class Session;

class DesignForm : public QWidget
{
    Q_OBJECT

public:
    explicit DesignForm(Session *session, QWidget *parent = nullptr);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void createControls();
    void requestStroke(double stroke);
    void requestDesign(const DesignRequest &request);
    void requestOffset(double timeRatio);
    void applyOrRefuse(const std::variant<Lengths, DesignFault> &designed, const DesignRequest &request);
    void apply(const Lengths &lengths);
    void refuse(const QString &sentence);
    void showParameters();
    void takeRequestFrom(const Parameters &parameters);
    void showRatio(const std::optional<DesignRange> &range);

    Session *m_session;
    Parameters m_parameters; ///< the mechanism whose stroke and time ratio are in m_request

    /// What the form shows and changes. The time ratio is below 1 if c < 0. The stroke is 0 as long as no mechanism had
    /// one.
    DesignRequest m_request;

    NumberBox *m_stroke;
    NumberBox *m_timeRatio;
    NumberBox *m_transmissionAngle;
    NumberSlider *m_ratio;
    QCheckBox *m_keepsLinks;
    QToolButton *m_bestButton;
    QLabel *m_ratioText;
    QLabel *m_refusal;
};

} // namespace slidercrank
