// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QString>
#include <QTranslator>

#include <algorithm>

namespace slidercrank
{

namespace
{

const QString kKey = "language";
const QString kTranslator = "translator"; // object name of the installed translators
const QString kTexts = "slidercrank";     // name of the translations of this program

/// Loads the first translation in a language of the locale, such as slidercrank_es.
void install(const QLocale &locale, const QString &name, const QString &folder)
{
    auto *translator = new QTranslator(QCoreApplication::instance());
    translator->setObjectName(kTranslator);
    if (!translator->load(locale, name, "_", folder) || !QCoreApplication::installTranslator(translator)) {
        delete translator;
    }
}

} // namespace

void setLanguage(Language language)
{
    const QLocale chosen(language == Language::Spanish ? QLocale::Spanish : QLocale::English);
    const bool isSystem = language == Language::System;
    const bool asSystem = QLocale::system().zeroDigit() == u"0" && // other digits could not be typed
                          (isSystem || QLocale::system().language() == chosen.language());
    QLocale::setDefault(asSystem ? QLocale::system() : chosen);
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator *>(kTranslator));
    const QLocale spoken = isSystem ? QLocale::system() : chosen;
    install(spoken, "qtbase", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(QLocale(QLocale::English), kTexts, ":/translations"); // the plural forms, if there is no other translation
    install(spoken, kTexts, ":/translations");
}

QLocale textLocale()
{
    QLocale::Language spoken = QLocale::English; // the language of the sources
    for (const QTranslator *translator : QCoreApplication::instance()->findChildren<QTranslator *>(kTranslator)) {
        if (QFileInfo(translator->filePath())
                .fileName()
                .startsWith(kTexts)) { // the translator installed last is in use
            spoken = QLocale(translator->language()).language();
        }
    }
    return QLocale(spoken, QLocale().territory());
}

Language chosenLanguage()
{
    const int stored = QSettings().value(kKey, 0).toInt();
    const int last = static_cast<int>(Language::Spanish); // limits a damaged setting
    return static_cast<Language>(std::clamp(stored, 0, last));
}

void storeLanguage(Language language)
{
    QSettings().setValue(kKey, static_cast<int>(language));
}

} // namespace slidercrank
