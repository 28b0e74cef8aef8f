#pragma once

#include "core/base/task.h"

#include <memory>
#include <utility>

namespace fumage {

class AirCache;

/// A task that needs the air of a scene: what has been baked of it is not baked again.
struct ExportTask : Task {
    using Task::Task;
    ExportTask() = default;
    /// @param airs null: the air is baked for this work alone
    // NOLINTNEXTLINE(google-explicit-constructor): most tasks have no airs
    ExportTask(Task task, std::shared_ptr<AirCache> airs = nullptr)
        : Task(std::move(task))
        , shelf(std::move(airs))
    {
    }

    std::shared_ptr<AirCache> shelf; ///< of air that is baked, or will be
};

/// The task with a shelf for what works on the same scene one after the other: its own, where it has one.
[[nodiscard]] ExportTask withShelf(const ExportTask& task);

} // namespace fumage
