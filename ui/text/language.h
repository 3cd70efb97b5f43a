// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The language of what people read, and with it how they write numbers. Files and their keys know none.

namespace slidercrank
{

enum class Language { System, English, Spanish };

/// Installs the translations of the application there is, Qt's own too where the system has them, and sets the default
/// locale: of the language chosen, the system's own variant where it is of that language. Widgets are told as by Qt,
/// with QEvent::LanguageChange. System: the first of the system's languages that there is, or else English.
void setLanguage(Language language);

/// What was chosen in the window, remembered with the settings.
Language chosenLanguage();
void rememberLanguage(Language language);

} // namespace slidercrank
