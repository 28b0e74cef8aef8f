#pragma once

#include "ui/document/key_edits.h"

namespace fumage::ui {

/// Puts key frames on the clipboard, as the JSON that presets have of them.
void copyKeys(const Document& document, const std::vector<KeyPlace>& keys);

/// Whether there are key frames on the clipboard.
[[nodiscard]] bool hasCopiedKeys();

/// Adds the key frames on the clipboard to the layer that is edited, the first of them at the time that is shown, as
/// one undo step.
/// @return those that were added
std::vector<KeyPlace> pasteKeys(Document& document);

} // namespace fumage::ui
