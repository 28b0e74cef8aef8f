#include "ui/document/file_mark.h"

#include "ui/document/text.h"

#include "core/system/file.h"
#include "core/base/sha256.h"
#include "core/preset/preset.h"

namespace fumage::ui {

FileMark markOfFile(const QString& path)
{
    const Result<std::string> text = readFile(toPath(path), kMaxPresetFileBytes);
    if (text) {
        return markOfText(text.value());
    }
    return text.error().code == ErrorCode::FileNotFound ? FileMark()
                                                        : FileMark::fromStdString(text.error().message.text());
}

FileMark markOfText(std::string_view text)
{
    Sha256 hash;
    hash.add(text);
    return FileMark::fromStdString(hash.finish());
}

} // namespace fumage::ui
