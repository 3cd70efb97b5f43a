// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lights up a part of the mechanism: lies over the drawing, lets the mouse through, and is hidden while there is
// nothing to point at.

#include "core/mechanism/mechanism_part.h"
#include "ui/document/result.h"

#include <QWidget>

namespace slidercrank
{

class MechanismView;

class PartHighlight : public QWidget
{
    Q_OBJECT

public:
    explicit PartHighlight(MechanismView *view);

public slots:
    void setPart(slidercrank::MechanismPart part);
    void setPose(const slidercrank::Pose &pose);
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void showOrHide();

    MechanismView *m_view;
    MechanismPart m_part = MechanismPart::None;
    Pose m_pose;
    Mechanism m_mechanism;
};

} // namespace slidercrank
