#include "ui/theme/svg_icon_plugin.h"

#include "ui/theme/svg_icon.h"

namespace fumage::ui {

QIconEngine* SvgIconPlugin::create(const QString& file)
{
    return makeSvgIconEngine(file);
}

} // namespace fumage::ui
