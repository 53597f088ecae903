#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Instructions.h>

#include <optional>
#include <string>

namespace mutation {

/// An operator as the source has it: of plain numbers, an instruction; of Fixed and flags, a call.
/// Both get the same mutant, so that a template for both is wrong in both.
struct Operation {
  unsigned opcode;                                                         ///< llvm::Instruction's
  llvm::CmpInst::Predicate predicate = llvm::CmpInst::BAD_ICMP_PREDICATE;  ///< of a comparison
  llvm::Value* left;
  llvm::Value* right;  ///< none of a minus sign
};

std::optional<Operation> operation_of(llvm::Instruction& instruction);

struct Wrong {
  std::string what;  ///< "+ becomes -"
  llvm::Value* value;
};

/// The operation used instead, of `type`; nothing if no other one makes sense.
std::optional<Wrong> wrong_operation(llvm::IRBuilder<>& builder, const Operation& operation,
                                     llvm::Type* type);

/// Whether the call is `a += b`, `a -= b` or `a |= b` of Fixed and flags.
bool is_compound_assignment(const llvm::CallInst& call);

}  // namespace mutation
