#include "ui/shell/history_view.h"

#include <QStyledItemDelegate>
#include <QUndoStack>

namespace fumage::ui {

namespace {

class StepDelegate : public QStyledItemDelegate {
public:
    StepDelegate(const QUndoStack& stack, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_stack(stack)
    {
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.row() > m_stack.index()) { // the first row is the document as it was opened
            option->state &= ~QStyle::State_Enabled;
        }
    }

private:
    const QUndoStack& m_stack;
};

} // namespace

HistoryView::HistoryView(QUndoStack* stack, QWidget* parent)
    : QUndoView(stack, parent)
{
    setObjectName(QStringLiteral("historyView"));
    setEmptyLabel(tr("As opened"));
    setAccessibleName(tr("Undo history"));
    setItemDelegate(new StepDelegate(*stack, this));
    // Qt draws the steps anew that it adds, and not those that are undone.
    connect(stack, &QUndoStack::indexChanged, viewport(), qOverload<>(&QWidget::update));
}

} // namespace fumage::ui
