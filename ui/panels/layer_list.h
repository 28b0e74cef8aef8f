#pragma once

#include "ui/document/document.h"

#include <QAbstractListModel>
#include <QWidget>

class QListView;
class QToolButton;

namespace fumage::ui {

/// The layers of a document for views: name, tag and whether each is seen.
class LayerModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit LayerModel(Document& document, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(
        const QMimeData* data, Qt::DropAction action, int row, int column, const QModelIndex& parent) override;

private:
    Document& m_document;
};

/// The list of layers above the parameters: which is edited, which are seen; new ones, copies, another order.
class LayerList : public QWidget {
    Q_OBJECT

public:
    explicit LayerList(Document& document, QWidget* parent = nullptr);

private:
    void follow();
    void openMenu(const QPoint& at);
    [[nodiscard]] std::size_t current() const { return m_document.layer(); }

    Document& m_document;
    LayerModel* m_model;
    QListView* m_view;
    QToolButton* m_add;
    QToolButton* m_duplicate;
    QToolButton* m_remove;
    bool m_follows = false; ///< what changes in the view is what the document said
};

} // namespace fumage::ui
