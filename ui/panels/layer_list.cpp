#include "ui/panels/layer_list.h"

#include "ui/theme/icons.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kMaxRows = 8; ///< that are seen at once
constexpr int kTags = 8;

QString nameOf(ColourTag tag)
{
    switch (tag) {
    case ColourTag::None: return LayerList::tr("None");
    case ColourTag::Red: return LayerList::tr("Red");
    case ColourTag::Orange: return LayerList::tr("Orange");
    case ColourTag::Yellow: return LayerList::tr("Yellow");
    case ColourTag::Green: return LayerList::tr("Green");
    case ColourTag::Blue: return LayerList::tr("Blue");
    case ColourTag::Violet: return LayerList::tr("Violet");
    case ColourTag::Grey: return LayerList::tr("Grey");
    }
    return {};
}

} // namespace

LayerList::LayerList(Document& document, Solo& solo, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_solo(solo)
    , m_transfer(document, *this)
    , m_view(new LayerView(document, solo, m_transfer, this))
    , m_add(makeIconButton(this, QStringLiteral("layers.add"), QStringLiteral("add"), tr("Add a layer")))
    , m_duplicate(makeIconButton(
          this, QStringLiteral("layers.duplicate"), QStringLiteral("duplicate"), tr("Duplicate the layer")))
    , m_remove(makeIconButton(this, QStringLiteral("layers.delete"), QStringLiteral("delete"), tr("Delete the layer")))
{
    setObjectName(QStringLiteral("layerList"));
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(0);
    for (QToolButton* button : {m_add, m_duplicate, m_remove}) {
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, 0);
    layout->setSpacing(2);
    layout->addWidget(m_view, 1);
    layout->addLayout(buttons);
    const auto remove = [this] { removeLayers(m_document, chosen()); };
    fillAddMenu();
    connect(m_duplicate, &QToolButton::clicked, this, [this] { duplicateLayers(m_document, chosen()); });
    connect(m_remove, &QToolButton::clicked, this, remove);
    connect(m_view, &LayerView::deleteRequested, this, remove);
    connect(m_view, &QWidget::customContextMenuRequested, this, &LayerList::openMenu);
    connect(&document, &Document::selectionChanged, this, &LayerList::follow);
    follow();
}

/// The plain one first: Enter takes it.
void LayerList::fillAddMenu()
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("layers.addMenu"));
    menu->addAction(tr("Smoke"), this, [this] { addLayer(m_document); });
    menu->addSeparator();
    for (const LayerTemplate& one : layerTemplates()) {
        menu->addAction(one.name, this, [this, one] { m_transfer.add(one); });
    }
    m_add->setMenu(menu);
    m_add->setPopupMode(QToolButton::InstantPopup);
}

void LayerList::follow()
{
    const int rows = m_view->layers().rowCount();
    m_duplicate->setVisible(rows > 1);
    m_remove->setVisible(rows > 1);
    m_add->setEnabled(m_document.scene().layers.size() < kMaxLayers);
    m_duplicate->setEnabled(m_add->isEnabled());
    m_remove->setEnabled(static_cast<int>(chosen().size()) < rows);
    const int row = std::max(m_view->sizeHintForRow(0), fontMetrics().height());
    const int buttons = rows > 1 ? 3 * m_add->sizeHint().height() : m_add->sizeHint().height();
    m_view->setFixedHeight(std::max(std::min(rows, kMaxRows) * row + 2 * m_view->frameWidth() + 2, buttons));
}

/// What concerns the marks of the layers that are chosen with one.
void LayerList::addMarks(QMenu& menu, std::size_t layer)
{
    const Layer& shown = m_document.scene().layers[layer];
    const LayerPlaces layers = m_view->layers().togetherWith(layer);
    menu.addAction(shown.visible ? tr("Mute") : tr("Show"), this,
        [this, layers, visible = !shown.visible] { setLayersVisible(m_document, layers, visible); });
    if (m_document.scene().layers.size() > 1) {
        const bool isSolo = m_solo.contains(layer);
        menu.addAction(
            isSolo ? tr("No longer solo") : tr("Solo"), this, [this, layers, isSolo] { m_solo.set(layers, !isSolo); });
    }
    if (m_solo.isOn()) {
        menu.addAction(tr("End solo"), &m_solo, &Solo::end);
    }
    menu.addAction(shown.locked ? tr("Unlock") : tr("Lock"), this,
        [this, layers, locked = !shown.locked] { setLayersLocked(m_document, layers, locked); });
    QMenu* tags = menu.addMenu(tr("Colour tag"));
    for (int i = 0; i < kTags; ++i) {
        const auto tag = static_cast<ColourTag>(i);
        tags->addAction(
            LayerModel::iconOf(tag), nameOf(tag), this, [this, layers, tag] { setLayersTag(m_document, layers, tag); });
    }
}

/// On whose particles the layers' own are born.
void LayerList::addParents(QMenu& menu, const LayerPlaces& layers)
{
    const Scene& scene = m_document.scene();
    if (scene.layers.size() < 2) {
        return;
    }
    QMenu* parents = menu.addMenu(tr("Born on"));
    parents->setObjectName(QStringLiteral("layerParents"));
    const auto add = [&](const QString& text, std::optional<std::size_t> parent) {
        QAction* action =
            parents->addAction(text, this, [this, layers, parent] { setLayersParent(m_document, layers, parent); });
        action->setCheckable(true);
        action->setChecked(std::all_of(
            layers.begin(), layers.end(), [&](std::size_t layer) { return parentOf(scene, layer) == parent; }));
        return action;
    };
    add(tr("Its emitter"), std::nullopt);
    parents->addSeparator();
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        add(plainMenuText(layerLabel(scene, i)), i)->setEnabled(canBeParent(scene, layers, i));
    }
}

void LayerList::addTransfer(QMenu& menu, const LayerPlaces& layers)
{
    menu.addAction(tr("Cut"), this, [this, layers] { m_transfer.cut(layers); })
        ->setEnabled(layers.size() < m_document.scene().layers.size());
    menu.addAction(tr("Copy"), this, [this, layers] { m_transfer.copy(layers); });
    menu.addAction(tr("Paste"), &m_transfer, &LayerTransfer::paste)->setEnabled(LayerTransfer::canPaste());
    menu.addAction(tr("Paste parameters…"), this, [this, layers] { m_transfer.pasteParameters(layers); })
        ->setEnabled(LayerTransfer::canPaste());
}

void LayerList::openMenu(const QPoint& at)
{
    const QModelIndex index = m_view->indexAt(at);
    if (!index.isValid()) {
        return;
    }
    const auto layer = static_cast<std::size_t>(index.row());
    const LayerPlaces layers = m_view->layers().togetherWith(layer);
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("layerMenu"));
    menu.addAction(tr("Rename"), this, [this, layer] { m_view->rename(layer); });
    addMarks(menu, layer);
    addParents(menu, layers);
    menu.addSeparator();
    addTransfer(menu, layers);
    menu.addSeparator();
    menu.addAction(tr("Duplicate"), this, [this, layers] { duplicateLayers(m_document, layers); })
        ->setEnabled(m_add->isEnabled());
    menu.addAction(tr("Delete"), this, [this, layers] { removeLayers(m_document, layers); })
        ->setEnabled(layers.size() < m_document.scene().layers.size());
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

} // namespace fumage::ui
