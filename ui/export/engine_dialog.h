#pragma once

#include "ui/concurrency/async_request.h"
#include "ui/export/engine_plan.h"
#include "ui/export/export_submission.h"
#include "ui/widgets/file_question.h"

#include <QDialog>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace fumage::ui {

class ExportProgress;
class MockStage;

/// The short way into an engine: one click on its name exports a flipbook with what it is best given, and ends with the
/// files playing on a mock ground and what is to be done in the engine. Does not block the window it belongs to.
class EngineDialog : public QDialog {
    Q_OBJECT

public:
    /// @param askForFile   for the folder
    /// @param askForChoice what becomes of files that are there
    EngineDialog(
        Document& document, ExportQueue& queue, AskForFile askForFile, AskForChoice askForChoice, QWidget* parent);

    [[nodiscard]] EngineChoice choice() const;
    void take(const EngineChoice& choice);
    /// Whether an export is on its way into the queue: its files are looked for.
    [[nodiscard]] bool isEntering() const { return m_entry.isBusy(); }
    [[nodiscard]] MockStage& stage() const { return *m_stage; }

signals:
    /// To the queue.
    void added(const fumage::ExportPlan& plan);
    /// Engine, folder or size, with an export that begins.
    void chosen();
    /// The export dialog is to be shown with this.
    void optionsRequested(const fumage::ExportPlan& plan);
    /// None is on its way into the queue any more.
    void entryEnded();

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QWidget* makeChoicePage();
    [[nodiscard]] QHBoxLayout* makeEngines();
    [[nodiscard]] QWidget* makeResultPage();
    [[nodiscard]] QHBoxLayout* makeButtons();
    void connectParts();
    void begin(Engine engine);
    /// The plan for an engine, whose cells the document has from now on.
    [[nodiscard]] ExportPlan prepare(Engine engine);
    void showChoice();
    void showResult();
    void followProgress();
    void readBack();
    void browse();
    [[nodiscard]] QString folder() const;

    Document& m_document;
    ExportQueue& m_queue;
    const AskForFile m_askForFile;
    ExportSubmission m_entry;
    Engine m_engine = Engine::Unity;
    std::optional<ExportPlan> m_plan; ///< that is being exported, or was
    bool m_isRead = false; ///< its files, or they are being read
    QStackedWidget* m_pages;
    QLineEdit* m_folder;
    QComboBox* m_edge;
    QLabel* m_title;
    QLabel* m_steps;
    MockStage* m_stage;
    ExportProgress* m_progress;
    QPushButton* m_back;
    QPushButton* m_cancel;
    QPushButton* m_show;
    QPushButton* m_copy;
    AsyncRequest m_reading; ///< last: its thread ends first
};

} // namespace fumage::ui
