#pragma once

class QMenu;

namespace fumage {
struct Track;
}

namespace fumage::ui {

class Document;
class KeySelection;

/// Fills a menu with all that is done to the key frames that are selected: how values go on, with pictures of it, what
/// holds outside of them, copy, paste, remove.
/// @param track that the menu is about; null: none
void fillKeyMenu(QMenu& menu, Document& document, KeySelection& selection, const Track* track);

} // namespace fumage::ui
