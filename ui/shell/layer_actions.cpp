#include "ui/shell/layer_actions.h"

#include "ui/document/solo.h"
#include "ui/panels/layer_list.h"
#include "ui/shell/action_table.h"

namespace fumage::ui {

LayerActions::LayerActions(const ActionSet& actions, Document& document, Solo& solo, LayerList& list)
    : QObject(&list)
    , m_actions(actions)
    , m_document(document)
    , m_solo(solo)
{
    LayerTransfer& transfer = list.transfer();
    const auto chosen = [&document] { return document.selection().all(); };
    actions.on("edit.cutLayers", this, [&transfer, chosen] { transfer.cut(chosen()); });
    actions.on("edit.copyLayers", this, [&transfer, chosen] { transfer.copy(chosen()); });
    actions.on("edit.pasteLayers", this, [&transfer] { transfer.paste(); });
    actions.on("edit.pasteParameters", this, [&transfer, chosen] { transfer.pasteParameters(chosen()); });
    actions.on("edit.duplicateLayers", this, [&document, chosen] { duplicateLayers(document, chosen()); });
    actions.on("edit.deleteLayers", this, [&document, chosen] { removeLayers(document, chosen()); });
    actions.on("view.endSolo", &solo, &Solo::end);
    for (const char* id : {"edit.cutLayers", "edit.copyLayers", "edit.pasteLayers", "edit.pasteParameters",
             "edit.duplicateLayers", "edit.deleteLayers"}) {
        QAction& action = actions.get(id);
        action.setShortcutContext(Qt::WidgetShortcut); // fields and the viewport have these keys for themselves
        list.view().addAction(&action);
    }
    connect(&document, &Document::selectionChanged, this, &LayerActions::follow);
    connect(&solo, &Solo::changed, this, &LayerActions::follow);
    follow();
}

void LayerActions::follow()
{
    const std::size_t layers = m_document.scene().layers.size();
    const bool isLeft = m_document.selection().all().size() < layers;
    m_actions.get("edit.cutLayers").setEnabled(isLeft);
    m_actions.get("edit.deleteLayers").setEnabled(isLeft);
    m_actions.get("edit.duplicateLayers").setEnabled(layers < kMaxLayers);
    m_actions.get("view.endSolo").setEnabled(m_solo.isOn());
}

} // namespace fumage::ui
