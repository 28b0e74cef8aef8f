#pragma once

#include "ui/document/search_index.h"
#include "ui/panels/parameter_group.h"

#include <vector>

class QLabel;
class QLineEdit;
class QTabBar;
class QToolButton;
class QVBoxLayout;

namespace fumage::ui {

class LayerList;
class Solo;
class VerticalScrollArea;

/// All parameters of the effect, generated from the parameter table: a search field above groups that fold. On top
/// those that an artist needs first stand once more.
class EffectPanel : public QWidget {
    Q_OBJECT

public:
    EffectPanel(Document& document, Locks& locks, Solo& solo, QWidget* parent = nullptr);

    [[nodiscard]] LayerList& layers() const { return *m_layers; }

    /// Scrolls to a group and opens it.
    void showGroup(std::string_view group);
    /// Opens the group of a parameter, scrolls to it and gives it the focus.
    void showParameter(const QString& key);
    /// Puts the cursor into the search field.
    void search();
    /// Which groups are open, for setOpenGroups().
    [[nodiscard]] QStringList openGroups() const;
    void setOpenGroups(const QStringList& groups);
    /// Those that are open as long as nobody says otherwise.
    [[nodiscard]] static QStringList usualGroups();

    QSize sizeHint() const override { return {392, 700}; }

private:
    void sync();
    void follow(const EffectChange& change);
    void filter();
    /// What is wanted of the rows, beside what is searched for.
    [[nodiscard]] RowFilter only() const;
    /// Why nothing is shown.
    [[nodiscard]] QString nothingText() const;
    void foldAll(bool open);
    void makeTabs();
    /// Tabs of the layer and of the scene, where there is more than one layer.
    void followLayers();
    /// Whose parameters are shown; none: all.
    [[nodiscard]] std::optional<Scope> shownScope() const;
    [[nodiscard]] QWidget* makeGroups(Locks& locks);

    Document& m_document;
    LayerList* m_layers;
    QTabBar* m_tabs;
    bool m_hasTabs = false;
    QLineEdit* m_search;
    QToolButton* m_onlyChanged;
    QToolButton* m_onlyAnimated;
    QLabel* m_nothing; ///< says that nothing was found
    VerticalScrollArea* m_scroll;
    QVBoxLayout* m_list = nullptr; ///< of the groups
    std::vector<ParameterGroup*> m_groups; ///< in their usual order
    SearchIndex m_index; ///< of the rows of all groups but the first
};

} // namespace fumage::ui
