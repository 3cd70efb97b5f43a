// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sets the language of the user interface and its number format. Files and their keys are the same in every language.

#include <QLocale>

namespace slidercrank
{

/// The settings store the number of the enumerator.
enum class Language { System = 0, English = 1, Spanish = 2 };

/// Installs the translations of the application, and those of Qt if the system has them, and sets the default locale.
/// The system's locale is used if it has the chosen language. Widgets receive QEvent::LanguageChange.
/// Language::System selects the first of the system's languages that is supported, or English if there is none.
void setLanguage(Language language);

/// Returns the locale for words in the language of the texts, such as the names of months. The default locale, which
/// writes numbers, may name months in a different language: that of the system, if only LANGUAGE chose the texts.
QLocale textLocale();

/// Read and store the language in the settings. A damaged setting is read as the nearest language.
Language chosenLanguage();
void storeLanguage(Language language);

} // namespace slidercrank
