// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A paint device that records each text drawn on it, with its tight bounding rectangle in px.

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QRectF>
#include <QSize>
#include <QString>
#include <QTransform>

#include <utility>
#include <vector>

class TextRecorder : public QPaintDevice, private QPaintEngine
{
public:
    using Text = std::pair<QString, QRectF>;

    explicit TextRecorder(const QSize &size)
        : QPaintEngine(QPaintEngine::AllFeatures)
        , m_size(size)
    {
    }

    QPaintEngine *paintEngine() const override { return const_cast<TextRecorder *>(this); }

    std::vector<Text> texts;

private:
    bool begin(QPaintDevice *) override { return true; }
    bool end() override { return true; }
    Type type() const override { return QPaintEngine::User; }
    void updateState(const QPaintEngineState &newState) override
    {
        if (newState.state().testFlag(DirtyTransform)) {
            m_transform = newState.transform();
        }
    }
    void drawPath(const QPainterPath &) override {}
    void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
    void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
    void drawTextItem(const QPointF &at, const QTextItem &item) override
    {
        const QRectF box = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
        texts.emplace_back(item.text(), m_transform.mapRect(box));
    }
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth: return m_size.width();
        case PdmHeight: return m_size.height();
        case PdmDepth: return 32;
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
        default: return 96;
        }
    }

    QSize m_size;
    QTransform m_transform;
};
