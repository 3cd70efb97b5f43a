// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sets the language of the user interface and its number format. Files and their keys are the same in every language.

namespace slidercrank
{

enum class Language { System, English, Spanish };

/// Installs the translations of the application, and those of Qt if the system has them, and sets the default locale.
/// The system's locale is used if it has the chosen language. Widgets receive QEvent::LanguageChange.
/// Language::System selects the first of the system's languages that is supported, or English if there is none.
void setLanguage(Language language);

/// Reads and writes the language in the settings.
Language chosenLanguage();
void rememberLanguage(Language language);

} // namespace slidercrank
