#pragma once

#include "ui/document/document.h"

namespace fumage::ui {

class ActionSet;
class LayerList;
class Solo;

/// The actions of the menus that are about the layers that are chosen. A child of their list.
class LayerActions : public QObject {
    Q_OBJECT

public:
    /// @param list whose keys they have while it has the focus
    LayerActions(const ActionSet& actions, Document& document, Solo& solo, LayerList& list);

private:
    void follow();

    const ActionSet& m_actions;
    const Document& m_document;
    const Solo& m_solo;
};

} // namespace fumage::ui
