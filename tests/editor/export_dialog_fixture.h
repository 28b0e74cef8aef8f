#pragma once

#include "editor_helpers.h"

#include "ui/export/export_dialog.h"

#include "core/effect/known_parameter.h"

#include <QLineEdit>
#include <QScrollArea>

#include <memory>

namespace fumage::tests {

/// The export dialog over a document, a timeline and a queue of its own for each test; without a window around it.
class ExportDialogFixture : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_answer = 0;
        m_document = std::make_unique<Document>();
        m_player = std::make_unique<Player>();
        m_player->setTimeline(100, 30);
        m_locks = std::make_unique<Locks>();
        m_queue = std::make_unique<ExportQueue>(QDir(m_folder.filePath(u"queue"_q)));
        m_dialog = std::make_unique<ExportDialog>(
            *m_document, *m_player, *m_locks, *m_queue, askInDialog,
            [this](QWidget*, const ChoiceQuestion&) { return m_answer; }, nullptr);
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    }
    void cleanup()
    {
        m_dialog.reset();
        m_queue.reset();
    }

protected:
    /// Whether the contents are as wide as what shows them, or narrower.
    bool fitsItsWidth()
    {
        const auto* scroll = child<QScrollArea>(u"export.scroll"_q);
        return scroll->viewport()->width() >= scroll->widget()->minimumSizeHint().width();
    }

    void setWidth(int pixels) { m_document->edit(knownParameter("output.width"), pixels); }

    void typePath(const QString& text)
    {
        auto* path = child<QLineEdit>(u"export.path"_q);
        path->selectAll();
        QTest::keyClicks(path, text);
    }

    template <class Widget>
    Widget* child(const QString& name)
    {
        auto* widget = m_dialog->findChild<Widget*>(name);
        Q_ASSERT(widget != nullptr);
        return widget;
    }

    int m_answer = 0; ///< to what is asked
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Player> m_player;
    std::unique_ptr<Locks> m_locks;
    QTemporaryDir m_folder;
    std::unique_ptr<ExportQueue> m_queue;
    std::unique_ptr<ExportDialog> m_dialog;
};

} // namespace fumage::tests
