#pragma once

#include "ui/panels/layer_view.h"

#include <QWidget>

class QMenu;
class QToolButton;

namespace fumage::ui {

/// The list of layers above the parameters: which is edited, which are seen; new ones, copies, another order.
class LayerList : public QWidget {
    Q_OBJECT

public:
    LayerList(Document& document, Solo& solo, QWidget* parent = nullptr);

    [[nodiscard]] LayerView& view() const { return *m_view; }
    [[nodiscard]] LayerTransfer& transfer() { return m_transfer; }

private:
    void fillAddMenu();
    void follow();
    void openMenu(const QPoint& at);
    void addMarks(QMenu& menu, std::size_t layer);
    void addParents(QMenu& menu, const LayerPlaces& layers);
    void addTransfer(QMenu& menu, const LayerPlaces& layers);
    [[nodiscard]] const LayerPlaces& chosen() const { return m_document.selection().all(); }

    Document& m_document;
    Solo& m_solo;
    LayerTransfer m_transfer;
    LayerView* m_view;
    QToolButton* m_add;
    QToolButton* m_duplicate;
    QToolButton* m_remove;
};

} // namespace fumage::ui
