// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/session.h"
#include "ui/mechanism/mechanism_frame.h"
#include "ui/mechanism/mechanism_sketch.h"
#include "ui/text/theme.h"

#include <algorithm>
#include <memory>

namespace slidercrank
{

/// The drawing of a mechanism at a time (s) in a view of `size` (px).
struct Drawn {
    MechanismScene scene;
    std::unique_ptr<MechanismSketch> sketch;

    explicit Drawn(const Parameters &parameters, double time, const MechanismSettings &settings = {},
                   const QSizeF &size = {800.0, 600.0}, double alpha2 = 0.0)
    {
        Session session;
        session.setParameters(parameters);
        session.setAlpha2(alpha2);
        scene.result = session.result();
        scene.pose = poseAt(parameters, time);
        scene.settings = settings;
        MechanismFrame frame;
        frame.fit(motionBounds(scene.mechanism(), scene.result->limits));
        sketch = std::make_unique<MechanismSketch>(scene, frame.projection(size), paletteFor(Theme::Light), QFont());
        sketch->addScenery();
        sketch->addLinkage();
    }

    /// `model`: a point of the mechanism, mm.
    DrawnPart partAt(QPointF model) const { return sketch->partAt(sketch->toPixels(model)); }
    /// Returns the box (px) of the first label that begins with the text, or a null box.
    QRectF label(const QString &text) const
    {
        const auto begins = [&text](const Label &label) { return label.text.startsWith(text); };
        const auto found = std::ranges::find_if(sketch->labels(), begins);
        return found == sketch->labels().end() ? QRectF() : found->box;
    }
};

} // namespace slidercrank
