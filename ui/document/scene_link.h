// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A link to the program in a browser that carries a scene, with the field names of scene files:
//
//     slidercrank.html#a=40&b=120&c=20&omega2=60rpm&theta20=30deg
//
// It contains the mechanism, and the settings of α₂, the time steps, the method and the view that differ from the
// initial settings of the window. It contains no reference, pinned motions or zoom. Numbers may have units; without a
// unit they are in the unit of scene files, except that angles other than 0 need one.

#include "ui/document/scene.h"

#include <QString>

#include <variant>

namespace slidercrank
{

/// Returns whether the text is a link with a scene, with or without an address before "#", and not the name of a file.
bool isSceneLink(const QString &text);

/// Returns the link with which parseSceneLink() gives the same settings, to the last bit.
QString sceneLink(const Scene &scene);

/// Returns the scene, or a sentence that says what is wrong with the link, and what to do.
std::variant<Scene, QString> parseSceneLink(const QString &link);

/// Sets the address of the page in the links, by default "slidercrank.html".
void setPageAddress(const QString &address);

} // namespace slidercrank
