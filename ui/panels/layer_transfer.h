#pragma once

#include "ui/document/layer_clipboard.h"
#include "ui/document/layer_templates.h"

#include <QObject>

class QWidget;

namespace fumage::ui {

/// Layers on their way: to the clipboard and from it, and from what is dropped on the list. What comes from outside is
/// checked as files are, and said where it cannot be taken.
class LayerTransfer : public QObject {
    Q_OBJECT

public:
    /// @param parent of the question which parameters are pasted; outlives this
    LayerTransfer(Document& document, QWidget& parent);

    void copy(const LayerPlaces& layers) const;
    /// Nothing is taken away where no layer would be left.
    void cut(const LayerPlaces& layers);
    /// After the layer that is edited.
    void paste();
    /// The same.
    void add(const LayerTemplate& from);
    /// Asks for groups of parameters, and gives those of the first layer on the clipboard to layers.
    void pasteParameters(const LayerPlaces& layers);
    /// Layers that are dropped before a place of the list: a preset, or files of presets.
    /// @return whether it was any of that
    bool drop(const QMimeData& data, std::size_t before);

    /// Whether something is on the clipboard that may be layers.
    [[nodiscard]] static bool canPaste();

signals:
    /// Something cannot be taken, or was taken with something put right.
    /// @param text what is wrong, for a person
    void refused(const QString& title, const QString& text);
    void news(const QString& message);

private:
    void insert(const PresetReading& reading, const QString& name, std::size_t at, const QString& text);
    void dropFile(const QString& path, std::size_t before);

    Document& m_document;
    QWidget& m_parent;
    std::vector<std::string_view> m_groups = layerGroups(); ///< that were pasted last
};

} // namespace fumage::ui
