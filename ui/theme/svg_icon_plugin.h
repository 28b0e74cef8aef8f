#pragma once

#include <QIconEnginePlugin>

namespace fumage::ui {

/// By this Qt finds the engine for the SVGs that the style sheet names.
class SvgIconPlugin : public QIconEnginePlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QIconEngineFactoryInterface_iid FILE "svg_icon_plugin.json")

public:
    using QIconEnginePlugin::QIconEnginePlugin;

    QIconEngine* create(const QString& file) override;
};

} // namespace fumage::ui
