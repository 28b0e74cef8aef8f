#include "core/preset/picture_file.h"

#include "core/base/base64.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/system/file.h"
#include "core/system/path.h"

namespace fumage {

Result<Bitmap> readPictureFile(const std::filesystem::path& path)
{
    const Result<std::string> bytes = readFile(path, kMaxPictureBytes);
    if (!bytes) {
        Error error = bytes.error();
        error.remedy = error.code == ErrorCode::TooLarge ? pictureRemedy() : error.remedy;
        return error;
    }
    Result<Bitmap> picture = Bitmap::read(std::as_bytes(std::span(bytes.value().data(), bytes.value().size())));
    if (picture) {
        return picture;
    }
    Error error = picture.error();
    error.place = path.string();
    return error;
}

Result<std::string> withPictureRead(std::string_view assignment)
{
    constexpr std::string_view kPngInBase64 = "iVBORw0KGgo";
    const std::size_t equals = assignment.find('=');
    const std::string_view target = trimmed(assignment.substr(0, equals));
    const Parameter* parameter = findParameter(target.substr(target.rfind('/') + 1)); // npos + 1 is 0
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view() : trimmed(assignment.substr(equals + 1));
    if (parameter == nullptr || parameter->kind != Kind::Picture || value.empty() || value.starts_with(kPngInBase64)) {
        return std::string(assignment);
    }
    const Result<Bitmap> picture = readPictureFile(pathFrom(value));
    return picture ? std::string(assignment.substr(0, equals + 1)) + base64Of(picture.value().file())
                   : Result<std::string>(picture.error());
}

} // namespace fumage
