#include "core/export/export_task.h"

#include "core/simulation/air_cache.h"

namespace fumage {

ExportTask withShelf(const ExportTask& task)
{
    ExportTask shared = task;
    if (!shared.shelf) {
        shared.shelf = std::make_shared<AirCache>();
    }
    return shared;
}

} // namespace fumage
