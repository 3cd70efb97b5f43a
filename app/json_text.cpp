// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/json_text.h"

#include "ui/export/motion_csv.h"
#include "ui/text/language.h"

#include <QLocale>

#include <charconv>
#include <cmath>

namespace slidercrank
{

InEnglish::InEnglish()
{
    setLanguage(Language::English);
    QLocale::setDefault(QLocale::c());
}

InEnglish::~InEnglish()
{
    setLanguage(Language::System);
}

void appendJsonNumber(QByteArray &text, double value)
{
    if (std::isfinite(value)) {
        appendNumber(text, value);
    } else {
        text.append("null");
    }
}

QByteArray jsonNumber(std::optional<double> value)
{
    if (!value || !std::isfinite(*value)) {
        return "null";
    }
    char digits[32];
    const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, *value == 0.0 ? 0.0 : *value);
    return QByteArray(digits, end.ptr - digits);
}

QByteArray jsonString(const QString &text)
{
    QByteArray json("\"");
    for (const char byte : text.toUtf8()) {
        switch (byte) {
        case '"': json += "\\\""; break;
        case '\\': json += "\\\\"; break;
        case '\n': json += "\\n"; break;
        case '\r': json += "\\r"; break;
        case '\t': json += "\\t"; break;
        default:
            if (static_cast<unsigned char>(byte) < 0x20) {
                json += "\\u" + QByteArray::number(byte, 16).rightJustified(4, '0');
            } else {
                json += byte;
            }
        }
    }
    return json + '"';
}

QByteArray jsonMechanism(const Mechanism &mechanism)
{
    return "{\"a\":" + jsonNumber(mechanism.a()) + ",\"b\":" + jsonNumber(mechanism.b()) +
           ",\"c\":" + jsonNumber(mechanism.c()) + ",\"omega2\":" + jsonNumber(mechanism.omega2()) +
           ",\"theta20\":" + jsonNumber(mechanism.theta20()) +
           ",\"branch\":" + (mechanism.branch() == Branch::Open ? "\"open\"" : "\"crossed\"") + '}';
}

} // namespace slidercrank
