#include "ui/panels/paste_dialog.h"

#include "ui/document/layer_clipboard.h"
#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include <algorithm>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

PasteDialog::PasteDialog(
    const QString& from, const QString& to, const std::vector<std::string_view>& ticked, QWidget* parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("pasteDialog"));
    setWindowTitle(tr("Paste parameters"));
    auto* text = new QLabel(tr("Give %1 these parameters of “%2”:").arg(to, from), this);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    auto* grid = new QGridLayout;
    for (const std::string_view group : layerGroups()) {
        auto* box = new QCheckBox(groupLabelOf(group), this);
        box->setObjectName(QStringLiteral("paste.") + toQString(group));
        box->setChecked(std::find(ticked.begin(), ticked.end(), group) != ticked.end());
        constexpr int kColumns = 2;
        const int place = static_cast<int>(m_boxes.size());
        grid->addWidget(box, place / kColumns, place % kColumns);
        m_boxes.push_back(box);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setText(tr("Paste"));
    connect(buttons->addButton(tr("All"), QDialogButtonBox::ResetRole), &QPushButton::clicked, this,
        [this] { tick(true); });
    connect(buttons->addButton(tr("None"), QDialogButtonBox::ResetRole), &QPushButton::clicked, this,
        [this] { tick(false); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto follow = [this, ok] { ok->setEnabled(!groups().empty()); };
    for (const QCheckBox* box : m_boxes) {
        connect(box, &QCheckBox::toggled, this, follow);
    }
    follow();
    auto* layout = new QVBoxLayout(this);
    constexpr int kMargin = 16;
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(kMargin / 2);
    layout->addWidget(text);
    layout->addLayout(grid);
    layout->addWidget(buttons);
}

std::vector<std::string_view> PasteDialog::groups() const
{
    const std::vector<std::string_view> all = layerGroups();
    std::vector<std::string_view> chosen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (m_boxes[i]->isChecked()) {
            chosen.push_back(all[i]);
        }
    }
    return chosen;
}

void PasteDialog::tick(bool all)
{
    for (QCheckBox* box : m_boxes) {
        box->setChecked(all);
    }
}

} // namespace fumage::ui
