// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/find_line.h"

#include "core/limits/crank_search.h"
#include "core/mechanism/turn.h"
#include "ui/document/session.h"
#include "ui/export/motion_table.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/quantity_text.h"
#include "ui/text/subscripts.h"
#include "ui/text/units.h"
#include "ui/text/written_number.h"
#include "ui/widgets/formula.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStringList>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slidercrank
{

/// Returns the angle (rad) that a crank at theta2 reaches first if it is turned counter-clockwise.
static double nextAngle(const std::vector<double> &angles, double theta2)
{
    constexpr double kRounding = 1e-9; // rad: a crank that is nearer is there already
    return std::ranges::min(angles, {}, [theta2](double angle) { return wrapToTwoPi(angle - theta2 - kRounding); });
}

FindLine::FindLine(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_quantity(named("findQuantity", new FormulaBox, tr("Quantity that has a value")))
    , m_value(named("findValue", new NumberBox, tr("Value of the quantity")))
    , m_useAsSpeedButton(named("findUseAsSpeed", new QToolButton, tr("Use as ω₂")))
{
    auto *next = named("findNext", new QToolButton, tr("Next"));
    next->setText(tr("Next"));
    next->setToolTip(tr("Turns the crank to the next position in which the quantity has this value"));
    next->setFocusPolicy(Qt::TabFocus);
    m_useAsSpeedButton->setText(tr("Use as ω₂"));
    m_useAsSpeedButton->setToolTip(
        tr("Sets the crank speed with which the velocity has this value at the present position"));
    m_useAsSpeedButton->setFocusPolicy(Qt::TabFocus);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(tr("Find")));
    row->addWidget(m_quantity);
    row->addWidget(new QLabel("="));
    row->addWidget(m_value);
    row->addWidget(next);
    row->addWidget(m_useAsSpeedButton);
    row->addStretch(1);
    connect(m_quantity, &QComboBox::activated, this, &FindLine::adaptToQuantity);
    connect(m_value, &NumberBox::edited, this, [this] { emit answered({}); });
    connect(m_value, &NumberBox::enterPressed, this, &FindLine::goToNext);
    connect(next, &QToolButton::clicked, this, &FindLine::goToNext);
    connect(m_useAsSpeedButton, &QToolButton::clicked, this, &FindLine::useAsCrankSpeed);
    refreshNotation();
}

void FindLine::refreshNotation()
{
    const int chosen = std::max(0, m_quantity->currentIndex());
    m_quantity->clear();
    for (const OutputChannel &channel : tableChannels()) {
        m_quantity->addItem(symbolOf(channel), columnName(channel));
        m_quantity->setItemData(m_quantity->count() - 1, nameText(channel), Qt::ToolTipRole);
    }
    m_quantity->setCurrentIndex(chosen);
    adaptToQuantity();
}

OutputChannel FindLine::wantedChannel() const
{
    return *outputChannelNamed(m_quantity->currentData().toString().toStdString()); // the list has only such names
}

double FindLine::wantedValue() const
{
    const OutputChannel channel = wantedChannel();
    const ShownScale scale = shownScale(channel, m_session->parameters().branch);
    return scale.inFileUnit(m_value->value()) / toFileUnit(measureOf(channel), 1.0);
}

void FindLine::adaptToQuantity()
{
    const OutputChannel channel = wantedChannel();
    const Measure measure = measureOf(channel);
    const QString unit = shownUnit(channel);
    m_value->setSuffix(unit == u"°" ? unit : u' ' + unit);
    m_value->setUnit({isAngular(measure) ? Dimension::Angle : Dimension::Length, static_cast<int>(orderOf(channel)),
                      1.0 / fromFileUnit(measure, 1.0, notation().units)});
    m_useAsSpeedButton->setVisible(orderOf(channel) == Order::Velocity);
    emit answered({});
}

QString FindLine::noPositionText() const
{
    const OutputChannel channel = wantedChannel();
    const bool isCouplerAngle = channel == OutputChannel(Channel{Theta3, Order::Position});
    const Mechanism mechanism(m_session->parameters());
    // Measured at the other end of the coupler, the angle differs by half a turn.
    if (isCouplerAngle && !crankAnglesAt(mechanism, channel, wantedValue() + 0.5 * kTurn)->empty()) {
        return notation().symbols == Symbols::Textbook
                   ? tr("There is no such position: this θ₃ is measured at B. Choose the angle at A in View > Notation "
                        "and units.")
                   : tr("There is no such position: this θ³ is measured at A. Choose the angle at B in View > Notation "
                        "and units.");
    }
    const std::optional<ChannelRange> range = rangeOf(mechanism, channel, m_session->alpha2());
    if (!range || !range->excludes(wantedValue())) {
        return tr("There is no such position.");
    }
    constexpr int kDigits = 5; // as in the table
    const Branch branch = mechanism.branch();
    const QString unit = shownUnit(channel);
    return tr("There is no such position: %1 lies between %2 and %3.")
        .arg(symbolOf(channel), withUnit(lowerBoundText(shownChannel(channel, branch, range->least), kDigits), unit),
             withUnit(upperBoundText(shownChannel(channel, branch, range->greatest), kDigits), unit));
}

void FindLine::goToNext()
{
    const OutputChannel channel = wantedChannel();
    const Mechanism mechanism(m_session->parameters());
    std::optional<std::vector<double>> angles = crankAnglesAt(mechanism, channel, wantedValue(), m_session->alpha2());
    QString answer;
    if (!angles || angles->empty()) {
        answer = noPositionText();
    } else if (mechanism.omega2() == 0.0) {
        m_session->setParameter(Parameter::Theta20, nextAngle(*angles, m_session->parameters().theta20));
    } else if (const auto time = nextTime(*angles, mechanism, m_session->sampling(), m_session->time())) {
        emit timeRequested(*time);
    } else {
        answer = tr("The crank does not reach these positions within the time range.");
    }
    if (answer.isEmpty()) {
        std::ranges::sort(*angles, {}, shownCrankAngle);
        QStringList texts;
        for (const double theta2 : *angles) {
            texts << crankAngleWithUnit(theta2);
        }
        answer = tr("Positions of a revolution: θ₂ = %1").arg(texts.join("; "));
    }
    emit answered(subscriptHtml(answer));
}

void FindLine::useAsCrankSpeed()
{
    const std::optional<double> speed = crankSpeedFor(Mechanism(m_session->parameters()),
                                                      m_session->pose().motion.theta2, wantedChannel(), wantedValue());
    if (speed && std::abs(*speed) <= kLargestParameter) {
        emit answered({});
        m_session->setCrankSpeedHere(*speed);
        emit timeRequested(m_session->time()); // shows the time in zoomed plots, too
        return;
    }
    emit answered(tr("No crank speed gives this velocity here: it is 0 at every speed, as at a dead centre."));
}

} // namespace slidercrank

#include "moc_find_line.cpp"
