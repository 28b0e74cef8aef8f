#pragma once

#include "ui/panels/layer_model.h"

#include <QListView>
#include <QStyledItemDelegate>

#include <optional>

namespace fumage::ui {

/// Draws a row of the list of layers: the eye and the solo in front, then tag or lock, then the name.
class LayerDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    /// What in front of a name can be clicked.
    enum class Button {
        Eye,
        Solo,
    };

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(
        QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
        const QModelIndex& index) override;

    /// The button at a place of a row.
    [[nodiscard]] static std::optional<Button> buttonAt(
        const QPoint& at, const QRect& row, const QAbstractItemModel& model);
    [[nodiscard]] static QRect placeOf(Button button, const QRect& row);
};

/// The rows of the layers: what a click on a button in front of a name does, and what is chosen.
class LayerView : public QListView {
    Q_OBJECT

public:
    LayerView(Document& document, Solo& solo, LayerTransfer& transfer, QWidget* parent);

    [[nodiscard]] LayerModel& layers() const { return *m_model; }
    /// Offers to change the name of a layer.
    void rename(std::size_t layer);

signals:
    /// The key for it was pressed.
    void deleteRequested();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    /// The row and its button under the mouse.
    struct Press {
        QPersistentModelIndex index;
        LayerDelegate::Button button;
    };
    [[nodiscard]] std::optional<Press> pressAt(const QPoint& at) const;
    void click(const Press& press, Qt::KeyboardModifiers modifiers);
    void take();
    void follow();

    Document& m_document;
    Solo& m_solo;
    LayerModel* m_model;
    bool m_isPressed = false; ///< on a button
    bool m_follows = false; ///< what changes in the view is what the document said
};

} // namespace fumage::ui
