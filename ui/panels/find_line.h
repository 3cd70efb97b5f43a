// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The line that finds the positions in which a quantity has a value, or the crank speed with which a velocity has it.

#include "core/limits/output_channel.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class Session;

class FindLine : public QWidget
{
    Q_OBJECT

public:
    explicit FindLine(Session *session, QWidget *parent = nullptr);

    /// Fills the list of the quantities again after a change of the notation. The chosen one stays.
    void refreshNotation();

signals:
    void timeRequested(double seconds);
    void answered(const QString &text); ///< HTML; empty: a message that was emitted before no longer applies

private:
    OutputChannel wantedChannel() const;
    double wantedValue() const; ///< in the core's unit: mm, rad, s
    void adaptToQuantity();     ///< sets the unit of the value, and shows or hides m_useAsSpeedButton
    void goToNext();
    QString noPositionText() const; ///< the answer if no position has the wanted value
    void useAsCrankSpeed();

    Session *m_session;
    QComboBox *m_quantity;
    NumberBox *m_value;
    QToolButton *m_useAsSpeedButton;
};

} // namespace slidercrank
