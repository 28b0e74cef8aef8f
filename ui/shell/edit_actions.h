#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"

namespace fumage::ui {

class ActionSet;

/// The actions that change the smoke as a whole, and take it back.
class EditActions : public QObject {
    Q_OBJECT

public:
    EditActions(const ActionSet& actions, Document& document, const Locks& locks);

private:
    void connectUndo();
    void nameUndo();
    void randomise();

    const ActionSet& m_actions;
    Document& m_document;
    const Locks& m_locks;
};

} // namespace fumage::ui
