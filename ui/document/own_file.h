#pragma once

#include "core/system/file_lock.h"

#include <QDir>
#include <QString>

#include <memory>
#include <vector>

namespace fumage::ui {

/// A file that a running program keeps for the next one, should it be killed. It belongs to whoever holds this.
struct OwnFile {
    QString path; ///< others beside it may have its name and more
    std::unique_ptr<FileLock> lock; ///< says that a running program owns the file
};

/// A name for a file that nobody else has; the file is not there yet.
/// @param folder the user's alone; made if it is not there
[[nodiscard]] OwnFile makeOwnFile(const QDir& folder);

/// Takes possession of the files that programs which are gone have left in a folder, the newest first. Clears away what
/// else they have left.
[[nodiscard]] std::vector<OwnFile> takeOrphans(const QDir& folder);

} // namespace fumage::ui
