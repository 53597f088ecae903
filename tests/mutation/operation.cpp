#include "operation.hpp"

#include <utility>

namespace mutation {
namespace {

using namespace llvm;

// What `fog::operator+` and the like are called in an object file: _ZN3fog, the operator's two
// letters, the types.
StringRef operator_letters(const CallInst& call) {
  const Function* const callee = call.getCalledFunction();
  StringRef name = callee == nullptr ? "" : callee->getName();
  return name.consume_front("_ZN3fog") ? name.take_front(2) : "";
}

struct Operator {
  const char* letters;
  unsigned opcode;
  CmpInst::Predicate predicate = CmpInst::BAD_ICMP_PREDICATE;
};
constexpr Operator kOperators[] = {
    {"pl", Instruction::Add},
    {"mi", Instruction::Sub},
    {"ml", Instruction::Mul},
    {"an", Instruction::And},
    {"or", Instruction::Or},
    {"eq", Instruction::ICmp, CmpInst::ICMP_EQ},
    {"ne", Instruction::ICmp, CmpInst::ICMP_NE},
    {"lt", Instruction::ICmp, CmpInst::ICMP_SLT},
    {"gt", Instruction::ICmp, CmpInst::ICMP_SGT},
    {"le", Instruction::ICmp, CmpInst::ICMP_SLE},
    {"ge", Instruction::ICmp, CmpInst::ICMP_SGE},
};

struct Replacement {
  unsigned opcode;
  const char* symbol;
  unsigned instead;
  const char* symbol_instead;
};
constexpr Replacement kReplacements[] = {
    {Instruction::Add, "+", Instruction::Sub, "-"},
    {Instruction::FAdd, "+", Instruction::FSub, "-"},
    {Instruction::Sub, "-", Instruction::Add, "+"},
    {Instruction::FSub, "-", Instruction::FAdd, "+"},
    {Instruction::Mul, "*", Instruction::Add, "+"},
    {Instruction::FMul, "*", Instruction::FAdd, "+"},
    {Instruction::SDiv, "/", Instruction::Mul, "*"},
    {Instruction::UDiv, "/", Instruction::Mul, "*"},
    {Instruction::FDiv, "/", Instruction::FMul, "*"},
    {Instruction::SRem, "%", Instruction::SDiv, "/"},
    {Instruction::URem, "%", Instruction::UDiv, "/"},
    {Instruction::Shl, "<<", Instruction::LShr, ">>"},
    {Instruction::LShr, ">>", Instruction::Shl, "<<"},
    {Instruction::AShr, ">>", Instruction::Shl, "<<"},
    {Instruction::And, "&", Instruction::Or, "|"},
    {Instruction::Or, "|", Instruction::And, "&"},
    {Instruction::Xor, "^", Instruction::Or, "|"},
};

const char* symbol(CmpInst::Predicate predicate) {
  switch (predicate) {
    case CmpInst::ICMP_EQ:
    case CmpInst::FCMP_OEQ:
      return "==";
    case CmpInst::ICMP_NE:
    case CmpInst::FCMP_UNE:
      return "!=";
    case CmpInst::ICMP_SLT:
    case CmpInst::ICMP_ULT:
    case CmpInst::FCMP_OLT:
      return "<";
    case CmpInst::ICMP_SLE:
    case CmpInst::ICMP_ULE:
    case CmpInst::FCMP_OLE:
      return "<=";
    case CmpInst::ICMP_SGT:
    case CmpInst::ICMP_UGT:
    case CmpInst::FCMP_OGT:
      return ">";
    default:
      return ">=";
  }
}

std::string becomes(const char* before, const char* after) {
  return std::string(before) + " becomes " + after;
}

Wrong wrong_comparison(IRBuilder<>& builder, const Operation& operation) {
  const auto predicate = operation.predicate;
  const auto instead = CmpInst::isEquality(predicate)
                           ? CmpInst::getInversePredicate(predicate)
                           : CmpInst::getFlippedStrictnessPredicate(predicate);
  return {becomes(symbol(predicate), symbol(instead)),
          builder.CreateCmp(instead, operation.left, operation.right)};
}

}  // namespace

std::optional<Operation> operation_of(Instruction& instruction) {
  if (auto* const compare = dyn_cast<CmpInst>(&instruction)) {
    // Of pointers only the ends of loops are compared, which is no operator of the source.
    if (compare->getOperand(0)->getType()->isPointerTy()) return std::nullopt;
    return Operation{compare->getOpcode(), compare->getPredicate(), compare->getOperand(0),
                     compare->getOperand(1)};
  }
  if (instruction.getOpcode() == Instruction::FNeg) {
    return Operation{Instruction::FNeg, CmpInst::BAD_ICMP_PREDICATE, instruction.getOperand(0),
                     nullptr};
  }
  if (isa<BinaryOperator>(instruction)) {
    return Operation{instruction.getOpcode(), CmpInst::BAD_ICMP_PREDICATE,
                     instruction.getOperand(0), instruction.getOperand(1)};
  }
  auto* const call = dyn_cast<CallInst>(&instruction);
  if (call == nullptr) return std::nullopt;
  for (Value* argument : call->args()) {
    if (!argument->getType()->isIntegerTy()) return std::nullopt;
  }
  const StringRef letters = operator_letters(*call);
  if (letters == "ng") {
    return Operation{Instruction::FNeg, CmpInst::BAD_ICMP_PREDICATE, call->getArgOperand(0),
                     nullptr};
  }
  if (call->arg_size() != 2) return std::nullopt;
  for (const Operator& known : kOperators) {
    if (letters == known.letters) {
      return Operation{known.opcode, known.predicate, call->getArgOperand(0),
                       call->getArgOperand(1)};
    }
  }
  return std::nullopt;
}

std::optional<Wrong> wrong_operation(IRBuilder<>& builder, const Operation& operation, Type* type) {
  if (operation.predicate != CmpInst::BAD_ICMP_PREDICATE) {
    return wrong_comparison(builder, operation);
  }
  if (operation.opcode == Instruction::FNeg) return Wrong{"- is left out", operation.left};
  if (operation.opcode == Instruction::Xor && type->isIntegerTy(1)) {
    return Wrong{"! is left out", operation.left};
  }
  for (const Replacement& known : kReplacements) {
    if (known.opcode != operation.opcode) continue;
    // The product of two Fixed is wider than they are.
    const auto widened = [&](Value* value) {
      return type->isIntegerTy() ? builder.CreateSExt(value, type) : value;
    };
    return Wrong{becomes(known.symbol, known.symbol_instead),
                 builder.CreateBinOp(static_cast<Instruction::BinaryOps>(known.instead),
                                     widened(operation.left), widened(operation.right))};
  }
  return std::nullopt;
}

bool is_compound_assignment(const CallInst& call) {
  const Function* const callee = call.getCalledFunction();
  if (callee == nullptr || call.arg_size() != 2) return false;
  const StringRef name = callee->getName();
  if (name.startswith("_ZN3fogoR")) return true;
  return name.startswith("_ZN3fog5FixedI") && (name.contains("EpLE") || name.contains("EmIE"));
}

}  // namespace mutation
