#pragma once

#include "editor_helpers.h"

#include "ui/document/layer_edits.h"
#include "ui/panels/layer_list.h"

namespace fumage::tests {

/// Names of all layers as they are shown, in their order.
inline QStringList names(const Document& document)
{
    QStringList all;
    for (std::size_t i = 0; i < document.scene().layers.size(); ++i) {
        all += layerLabel(document.scene(), i);
    }
    return all;
}

/// A document with the layers flames, smoke and embers.
class LayersFixture : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        Preset preset;
        for (const char* name : {"flames", "smoke", "embers"}) {
            Layer layer;
            layer.name = name;
            layer.emitter.seed = static_cast<std::uint32_t>(preset.scene.layers.size());
            preset.scene.layers.push_back(layer);
        }
        preset.scene.layers.erase(preset.scene.layers.begin());
        m_document.load(preset, {});
    }

protected:
    Document m_document;
};

} // namespace fumage::tests
