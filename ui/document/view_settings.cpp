// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/view_settings.h"

#include "core/mechanism/channel.h"

#include <string_view>

namespace slidercrank
{

QString plotName(std::size_t plot)
{
    static const std::array<QString, 3> kErrors{QStringLiteral("plot_error_position"),
                                                QStringLiteral("plot_error_velocity"),
                                                QStringLiteral("plot_error_acceleration")};
    if (isErrorPlot(plot)) {
        return kErrors[plot / kPlotColumns];
    }
    return QStringLiteral("plot_") + QString::fromUtf8(nameOf(kPlottedChannels[channelOf(plot)]));
}

} // namespace slidercrank
