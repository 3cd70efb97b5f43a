// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/channel_text.h"

#include "core/import/reference_data.h"
#include "ui/text/notation.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct BodyWords {
    const char *name;        ///< untranslated
    const char *superscript; ///< in absolute coordinates
};

struct ChannelText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ChannelText)

public:
    static BodyWords bodyOf(Coordinate coordinate)
    {
        switch (coordinate) {
        case R1x:
        case R1y:
        case Theta1: break;
        case R2x:
        case R2y:
        case Theta2: return {QT_TR_NOOP("crank"), "²"};
        case R3x:
        case R3y:
        case Theta3: return {QT_TR_NOOP("coupler"), "³"};
        case R4x:
        case R4y:
        case Theta4: return {QT_TR_NOOP("slider"), "⁴"};
        }
        return {QT_TR_NOOP("ground"), "¹"};
    }

    /// The names of a position and of its derivatives, for any body. Untranslated.
    struct QuantityNames {
        const char *position;
        const char *velocity;
        const char *acceleration;

        const char *nameFor(Order order) const
        {
            switch (order) {
            case Order::Position: break;
            case Order::Velocity: return velocity;
            case Order::Acceleration: return acceleration;
            }
            return position;
        }
    };

    static QuantityNames namesOf(Coordinate coordinate)
    {
        if (isAngle(coordinate)) {
            return {QT_TR_NOOP("%1 angle"), QT_TR_NOOP("%1 angular velocity"), QT_TR_NOOP("%1 angular acceleration")};
        }
        if (coordinate == R4x) {
            return {QT_TR_NOOP("%1 position"), QT_TR_NOOP("%1 velocity"), QT_TR_NOOP("%1 acceleration")};
        }
        if (isAlongX(coordinate)) {
            return {QT_TR_NOOP("%1 centre in x"), QT_TR_NOOP("%1 centre's velocity in x"),
                    QT_TR_NOOP("%1 centre's acceleration in x")};
        }
        return {QT_TR_NOOP("%1 centre in y"), QT_TR_NOOP("%1 centre's velocity in y"),
                QT_TR_NOOP("%1 centre's acceleration in y")};
    }

    static QString quantity(Channel channel)
    {
        return tr(namesOf(channel.coordinate).nameFor(channel.order)).arg(tr(bodyOf(channel.coordinate).name));
    }
};

} // namespace

QString symbolText(Channel channel)
{
    if (notation().symbols == Symbols::Textbook && (channel.coordinate == Theta3 || channel.coordinate == R4x)) {
        const bool isCoupler = channel.coordinate == Theta3;
        switch (channel.order) {
        case Order::Position: break;
        case Order::Velocity: return isCoupler ? "ω₃" : "v_B";
        case Order::Acceleration: return isCoupler ? "α₃" : "a_B";
        }
        return isCoupler ? "θ₃" : "x_B";
    }
    return absoluteSymbolText(channel);
}

QString absoluteSymbolText(Channel channel)
{
    const bool isAngular = isAngle(channel.coordinate);
    const bool omitsDirection = isAngular || (channel.coordinate == R4x && channel.order != Order::Position);
    const QString body = channel.coordinate == Theta2 ? "₂" : ChannelText::bodyOf(channel.coordinate).superscript;
    QString direction;
    if (!omitsDirection) {
        direction = isAlongX(channel.coordinate) ? "ₓ" : "_y";
    }
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return (isAngular ? "ω" : "v") + direction + body;
    case Order::Acceleration: return (isAngular ? "α" : "a") + direction + body;
    }
    return (isAngular ? "θ" : "R") + direction + body;
}

QString quantityName(Channel channel)
{
    return ChannelText::quantity(channel);
}

QString columnName(Channel channel)
{
    return QString::fromUtf8(nameOf(channel));
}

QString unitText(Channel channel)
{
    return QString::fromUtf8(fileUnit(channel));
}

} // namespace slidercrank
