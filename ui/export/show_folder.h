#pragma once

#include "core/export/export_plan.h"
#include "ui/document/text.h"

#include <QDesktopServices>
#include <QUrl>

namespace fumage::ui {

/// Opens the folder that an export writes into, with the program that the desktop has for it.
inline void showFolderOf(const ExportPlan& plan)
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(fromPath(plan.output.parent_path())));
}

} // namespace fumage::ui
