#pragma once

#include "ui/document/layer_edits.h"
#include "ui/document/solo.h"
#include "ui/panels/layer_transfer.h"

#include <QAbstractListModel>
#include <QIcon>

namespace fumage::ui {

/// The layers of a document for views: name, tag, whether each is seen, and whether it is looked at alone. Changes of
/// rows that are chosen together are changes of all of them.
class LayerModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        Solo = Qt::UserRole, ///< bool
        Particles, ///< how many, as text; empty where a layer is alone
    };

    /// @param transfer takes what is dropped from elsewhere
    LayerModel(Document& document, ui::Solo& solo, LayerTransfer& transfer, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    [[nodiscard]] Qt::DropActions supportedDragActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(
        const QMimeData* data, Qt::DropAction action, int row, int column, const QModelIndex& parent) override;

    /// Takes what a picture has cost, for tool tips: pictures for which nothing had to be simulated say nothing.
    /// @param particleSteps of each layer of the scene
    void noteWork(const std::vector<double>& particleSteps);
    /// All that are chosen where a layer is one of them; else that layer.
    [[nodiscard]] LayerPlaces togetherWith(std::size_t layer) const;
    [[nodiscard]] static QIcon iconOf(ColourTag tag);

private:
    void follow();
    void repaint();
    [[nodiscard]] QString statisticsOf(std::size_t layer) const;
    /// What rows of this list alone are dragged as.
    [[nodiscard]] QString rowsMimeType() const;
    [[nodiscard]] LayerPlaces rowsOf(const QMimeData& data) const;

    Document& m_document;
    ui::Solo& m_solo;
    LayerTransfer& m_transfer;
    int m_rows; ///< as views know them
    std::vector<double> m_work; ///< particle steps of each layer, of the last pictures; empty: not known
};

} // namespace fumage::ui
