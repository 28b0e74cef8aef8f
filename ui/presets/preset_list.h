#pragma once

#include "ui/presets/library_reader.h"
#include "ui/presets/thumbnailer.h"

#include <QHash>
#include <QListWidget>

#include <vector>

namespace fumage::ui {

/// Pictures of presets with their names: the built-in ones, the favourites and the user's own.
class PresetList : public QListWidget {
    Q_OBJECT

public:
    explicit PresetList(int edge, QWidget* parent = nullptr);

    /// Reads the library anew; the list is filled as it is read.
    void reload();
    /// @param words empty: all; favourites are the ids that come first and have a star
    void filter(const QString& words, bool onlyFavourites);
    void setFavourites(const QStringList& ids);

    [[nodiscard]] const LibraryEntry* entryOf(const QListWidgetItem* item) const;
    /// The preset of an item as it was read; nothing where its file is broken.
    [[nodiscard]] const Preset* presetOf(const QListWidgetItem* item) const;
    [[nodiscard]] QString idOf(const QListWidgetItem* item) const;

    /// What is dragged out of the list: an id that presetOfId() knows; beside it the preset itself, for lists of
    /// layers.
    static QString mimeType();
    [[nodiscard]] const Preset* presetOfId(const QString& id) const;

signals:
    void chosen(const fumage::Preset& preset);

protected:
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] const LibraryPreset* shelfOf(const QListWidgetItem* item) const;
    /// What is said where nothing is wanted.
    [[nodiscard]] QString emptyRemark() const;
    [[nodiscard]] bool isWanted(const QListWidgetItem& item) const;
    void add(const std::vector<LibraryPreset>& presets, bool first);
    void add(const LibraryPreset& preset);
    void receive(const QString& id, const QImage& image);
    void label(QListWidgetItem& item) const;

    LibraryReader m_reader;
    Thumbnailer m_thumbnailer;
    std::vector<LibraryPreset> m_shelves; ///< one an item, found by its index in the item's data
    QHash<QString, QListWidgetItem*> m_items; ///< by id
    QStringList m_words;
    QStringList m_favourites;
    bool m_onlyFavourites = false;
    int m_edge;
    bool m_loaded = false;
};

} // namespace fumage::ui
