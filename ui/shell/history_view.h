#pragma once

#include <QUndoView>

namespace fumage::ui {

/// The undo steps of a document; those that are undone stand back.
class HistoryView : public QUndoView {
    Q_OBJECT

public:
    explicit HistoryView(QUndoStack* stack, QWidget* parent = nullptr);
};

} // namespace fumage::ui
