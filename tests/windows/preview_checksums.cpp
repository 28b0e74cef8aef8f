// Prints what the editor's viewport shows of the golden scenes, without a graphics card:  preview_checksums
// [presets]... One line each: preset, SHA-256 of the pixels.

#include "tests/golden/checksum.h"

#include "ui/preview/preview_renderer.h"

#include "core/base/sha256.h"
#include "core/preset/library.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

using namespace fumage;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

std::string checksumOf(const QImage& image)
{
    const QImage plain = image.convertToFormat(QImage::Format_RGB32);
    Sha256 hash;
    for (int y = 0; y < plain.height(); ++y) {
        hash.add(std::string_view(reinterpret_cast<const char*>(plain.constScanLine(y)),
            static_cast<std::size_t>(plain.width()) * sizeof(QRgb)));
    }
    return hash.finish();
}

bool printLine(const std::string& id)
{
    ui::RenderRequest request;
    request.scene = std::make_shared<const Scene>(tests::goldenScene(id));
    request.frame = tests::kGoldenFrame;
    request.width = kWidth;
    request.height = kHeight;
    ui::PreviewRenderer renderer;
    const ui::PicturePtr picture = renderer.make(request, {});
    if (picture == nullptr) {
        std::fprintf(stderr, "%s: %s\n", id.c_str(), renderer.trouble() ? renderer.trouble()->text().c_str() : "");
        return false;
    }
    std::printf("%s %s\n", id.c_str(), checksumOf(picture->image).c_str());
    std::fflush(stdout);
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<std::string> ids(argv + 1, argv + argc);
    if (ids.empty()) {
        for (const LibraryEntry& entry : builtinPresets()) {
            ids.push_back(entry.id);
        }
    }
    for (const std::string& id : ids) {
        if (!printLine(id)) {
            return 1;
        }
    }
    return 0;
}
