// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <cstdio>

namespace slidercrank
{

void say(const QString &sentence)
{
    const QByteArray line = sentence.toLocal8Bit() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

QString rounded(std::optional<double> value, int digits)
{
    return value ? QString::number(*value, 'g', digits) : QStringLiteral("–");
}

} // namespace slidercrank
