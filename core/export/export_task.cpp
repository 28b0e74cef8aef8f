#include "core/export/export_task.h"

#include "core/simulation/air_cache.h"

namespace fumage {

ExportTask withShelf(const ExportTask& task)
{
    return {task, task.shelf ? task.shelf : std::make_shared<AirCache>()};
}

} // namespace fumage
