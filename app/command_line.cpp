// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "ui/text/written_number.h"

#include <cstdio>

namespace slidercrank
{

ExitStatus graver(ExitStatus x, ExitStatus y)
{
    for (const ExitStatus status :
         {ExitStatus::FileFailed, ExitStatus::NotAssemblable, ExitStatus::NotSolved, ExitStatus::Differs}) {
        if (x == status || y == status) {
            return status;
        }
    }
    return ExitStatus::Done;
}

void say(const QString &sentence)
{
    const QByteArray line = sentence.toUtf8() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

QString rounded(std::optional<double> value, int digits)
{
    return value ? typedNumberText(QString::number(*value, 'g', digits).toDouble()) : dash();
}

} // namespace slidercrank
