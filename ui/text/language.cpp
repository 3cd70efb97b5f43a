// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QString>
#include <QTranslator>

namespace slidercrank
{

namespace
{

const QString kKey = "language";
const QString kTranslator = "translator"; // object name of the installed translators

QString codeOf(QLocale::Language language)
{
    return language == QLocale::Spanish ? "es" : "en";
}

QLocale::Language systemLanguage()
{
    for (const QString &name : QLocale::system().uiLanguages()) {
        const QLocale::Language language = QLocale(name).language();
        if (language == QLocale::English || language == QLocale::Spanish) {
            return language;
        }
    }
    return QLocale::English;
}

void install(const QString &file, const QString &folder)
{
    auto *translator = new QTranslator(QCoreApplication::instance());
    translator->setObjectName(kTranslator);
    if (!translator->load(file, folder) || !QCoreApplication::installTranslator(translator)) {
        delete translator;
    }
}

} // namespace

void setLanguage(Language language)
{
    const QLocale::Language spoken = language == Language::System    ? systemLanguage()
                                     : language == Language::Spanish ? QLocale::Spanish
                                                                     : QLocale::English;
    const bool asSystem = language == Language::System || QLocale::system().language() == spoken;
    QLocale::setDefault(asSystem ? QLocale::system() : QLocale(spoken));

    const QString code = codeOf(spoken);
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator *>(kTranslator));
    install("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install("slidercrank_" + code, ":/translations");
}

Language chosenLanguage()
{
    const QString code = QSettings().value(kKey).toString();
    return code == codeOf(QLocale::Spanish)   ? Language::Spanish
           : code == codeOf(QLocale::English) ? Language::English
                                              : Language::System;
}

void rememberLanguage(Language language)
{
    const QString code = codeOf(language == Language::Spanish ? QLocale::Spanish : QLocale::English);
    QSettings().setValue(kKey, language == Language::System ? QString() : code);
}

} // namespace slidercrank
