// An LLVM pass that inserts mutants into firmware/core: beside each operation a wrong one, selected
// at run time, so that a program is compiled once for all mutants. Writes them to a file in the
// folder FOG_MUTANTS, one line each: number, place, change. A template or an inline function has
// the same mutant numbers wherever it is compiled.
//
// Not covered: compile-time computation (constexpr, tables, template arguments), pointers, and
// loops over ranges.
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Passes/PassPlugin.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>

#include <cstdlib>
#include <fstream>
#include <vector>

#include "operation.hpp"

namespace mutation {
namespace {

using namespace llvm;

constexpr const char* kMutated = "firmware/core/";

/// firmware/core/FILE:LINE:COLUMN; nothing for code of anywhere else.
std::optional<std::string> place_of(const Instruction& instruction) {
  const DebugLoc& where = instruction.getDebugLoc();
  if (!where || where.getLine() == 0) return std::nullopt;
  const std::string file = (where->getDirectory() + "/" + where->getFilename()).str();
  const std::size_t at = file.rfind(kMutated);
  if (at == std::string::npos) return std::nullopt;
  return file.substr(at) + ":" + std::to_string(where->getLine()) + ":" +
         std::to_string(where->getColumn());
}

// The same mutant has the same number in every program: FNV-1a.
std::uint32_t number_of(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char character : text) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 16777619U;
  }
  return hash & 0x7FFFFFFFU;
}

class Mutator {
 public:
  explicit Mutator(Module& module)
      : chosen_(*cast<GlobalVariable>(
            module.getOrInsertGlobal("fog_mutant", Type::getInt32Ty(module.getContext())))) {}

  void mutate(Instruction& instruction) {
    const auto place = place_of(instruction);
    if (!place) return;
    place_ = *place;
    if (isa<IntrinsicInst>(instruction)) return;
    if (auto* const phi = dyn_cast<PHINode>(&instruction)) return mutate_choice(*phi);
    if (auto* const branch = dyn_cast<BranchInst>(&instruction)) return mutate_condition(*branch);
    mutate_constants(instruction);
    if (auto* const store = dyn_cast<StoreInst>(&instruction)) return mutate_store(*store);
    if (auto* const call = dyn_cast<CallInst>(&instruction)) mutate_call(*call);
    mutate_operation(instruction);
  }

  const std::string& made() const { return made_; }

 private:
  // Whether the mutant is the one that was chosen, at the builder's place. `kind` tells it from the
  // others of the place, where `what` differs from one instance of a template to the next.
  Value* is_chosen(IRBuilder<>& builder, const std::string& what, const std::string& kind = "") {
    const std::uint32_t number = number_of(place_ + " " + (kind.empty() ? what : kind));
    made_ += std::to_string(number) + " " + place_ + " " + what + "\n";
    LoadInst* const chosen = builder.CreateLoad(builder.getInt32Ty(), &chosen_);
    chosen->setMetadata(LLVMContext::MD_invariant_load, MDNode::get(builder.getContext(), {}));
    return builder.CreateICmpEQ(chosen, builder.getInt32(number));
  }

  void mutate_operation(Instruction& instruction) {
    const auto operation = operation_of(instruction);
    if (!operation) return;
    IRBuilder<> builder(instruction.getNextNode());
    const auto wrong = wrong_operation(builder, *operation, instruction.getType());
    if (!wrong) return;
    Value* const chosen = is_chosen(builder, wrong->what);
    auto* const select =
        cast<SelectInst>(builder.Insert(SelectInst::Create(chosen, wrong->value, &instruction)));
    instruction.replaceUsesWithIf(
        select, [&](Use& use) { return use.getUser() != select && use.getUser() != wrong->value; });
  }

  // Operands that are numbers: one more; 1 and true become 0 and false.
  void mutate_constants(Instruction& instruction) {
    if (instruction.isTerminator() && !isa<ReturnInst>(instruction)) return;
    if (isa<AllocaInst>(instruction) || isa<GetElementPtrInst>(instruction) ||
        isa<InsertValueInst>(instruction)) {
      return;
    }
    const bool is_call = isa<CallInst>(instruction);
    for (Use& use : instruction.operands()) {
      const auto* const constant = dyn_cast<ConstantInt>(use.get());
      if (constant == nullptr || (is_call && use.getOperandNo() >= argument_count(instruction))) {
        continue;
      }
      // ++ and --, whose direction is mutated, and !; bounds, which are let in and left out.
      if (instruction.getOpcode() == Instruction::Add &&
          (constant->isOne() || constant->isMinusOne()))
        continue;
      if (instruction.getOpcode() == Instruction::Xor && constant->getType()->isIntegerTy(1))
        continue;
      if (instruction.getOpcode() == Instruction::Sub && constant->isZero()) continue;  // -x
      if (const auto* const compare = dyn_cast<ICmpInst>(&instruction)) {
        if (compare->isRelational()) continue;
      }
      IRBuilder<> builder(&instruction);
      use.set(other_number(builder, *constant, use.getOperandNo(), instruction.isShift()));
    }
  }

  static unsigned argument_count(const Instruction& call) {
    return cast<CallInst>(call).arg_size();
  }

  Value* other_number(IRBuilder<>& builder, const ConstantInt& constant, unsigned operand,
                      bool is_shift) {
    APInt other = constant.getValue() + 1;
    if (constant.isOne()) other = 0;
    if (is_shift && other.uge(constant.getBitWidth())) other = constant.getValue() - 1;
    const auto text = [](const APInt& value) {
      if (value.getBitWidth() == 1) return std::string(value.isZero() ? "false" : "true");
      SmallString<24> digits;
      value.toStringSigned(digits);
      return digits.str().str();
    };
    Value* const chosen = is_chosen(builder, text(constant.getValue()) + " becomes " + text(other),
                                    "constant " + std::to_string(operand));
    return builder.CreateSelect(chosen, ConstantInt::get(constant.getType(), other),
                                ConstantInt::get(constant.getType(), constant.getValue()));
  }

  // a ? 1 : 2, a && b, a || b: the numbers among them.
  void mutate_choice(PHINode& phi) {
    for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
      const auto* const constant = dyn_cast<ConstantInt>(phi.getIncomingValue(i));
      if (constant == nullptr) continue;
      IRBuilder<> builder(phi.getIncomingBlock(i)->getTerminator());
      phi.setIncomingValue(i, other_number(builder, *constant, i, false));
    }
  }

  void mutate_condition(BranchInst& branch) {
    if (!branch.isConditional()) return;
    Value* const condition = branch.getCondition();
    if (const auto* const compare = dyn_cast<CmpInst>(condition)) {
      if (compare->isEquality()) return;  // == becomes !=
    }
    IRBuilder<> builder(&branch);
    Value* const chosen = is_chosen(builder, "the condition is negated");
    branch.setCondition(builder.CreateXor(condition, chosen));
  }

  // Writes the present value again. Only for data that outlive the function: a local variable would
  // be left undefined.
  void mutate_store(StoreInst& store) {
    Type* const type = store.getValueOperand()->getType();
    if (!type->isIntegerTy() && !type->isFloatingPointTy()) return;
    if (isa<AllocaInst>(getUnderlyingObject(store.getPointerOperand())) || store.isVolatile()) {
      return;
    }
    IRBuilder<> builder(&store);
    Value* const before = builder.CreateLoad(type, store.getPointerOperand());
    Value* const chosen = is_chosen(builder, "is not written");
    store.setOperand(0, builder.CreateSelect(chosen, before, store.getValueOperand()));
  }

  void mutate_call(CallInst& call) {
    const Function* const callee = call.getCalledFunction();
    if (callee == nullptr) return;
    if (is_compound_assignment(call) && call.getArgOperand(1)->getType()->isIntegerTy()) {
      IRBuilder<> builder(&call);
      Value* const chosen = is_chosen(builder, "the assignment is left out");
      Value* const operand = call.getArgOperand(1);
      call.setArgOperand(
          1, builder.CreateSelect(chosen, ConstantInt::get(operand->getType(), 0), operand));
      return;
    }
    const StringRef name = callee->getName();
    const bool constructs = name.contains("C1E") || name.contains("C2E") || name.contains("C2I");
    if (!call.getType()->isVoidTy() || call.hasStructRetAttr() || constructs) return;
    IRBuilder<> builder(&call);
    Value* const done = builder.CreateNot(is_chosen(builder, "is not called"));
    Instruction* const then = SplitBlockAndInsertIfThen(done, &call, false);
    call.moveBefore(then);
  }

  GlobalVariable& chosen_;
  std::string place_;
  std::string made_;
};

class Mutate : public PassInfoMixin<Mutate> {
 public:
  static bool isRequired() { return true; }

  PreservedAnalyses run(Module& module, ModuleAnalysisManager& /*analyses*/) {
    Mutator mutator(module);
    for (Function& function : module) {
      std::vector<Instruction*> all;
      for (Instruction& instruction : instructions(function)) all.push_back(&instruction);
      for (Instruction* const instruction : all) mutator.mutate(*instruction);
    }
    if (const char* const folder = std::getenv("FOG_MUTANTS")) {
      const std::string name = std::to_string(number_of(module.getModuleIdentifier()));
      std::ofstream(std::string(folder) + "/" + name) << mutator.made();
    }
    return mutator.made().empty() ? PreservedAnalyses::all() : PreservedAnalyses::none();
  }
};

}  // namespace
}  // namespace mutation

extern "C" LLVM_ATTRIBUTE_WEAK ::llvm::PassPluginLibraryInfo llvmGetPassPluginInfo() {
  return {LLVM_PLUGIN_API_VERSION, "mutate", "1", [](llvm::PassBuilder& builder) {
            builder.registerPipelineStartEPCallback(
                [](llvm::ModulePassManager& passes, llvm::OptimizationLevel /*level*/) {
                  passes.addPass(mutation::Mutate());
                });
          }};
}
