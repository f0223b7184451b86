// Dynamic scene S6: bodies, control program and contact events.
// What plays them is AEsgScene.
// Units: cm, kg, s, degrees. Frame: Unreal's, left-handed, Z up. Place the actor at the origin.
#pragma once

#include "EsgScene.h"
#include "EsgScene_S6.generated.h"

UCLASS()
class ESGSCENES_API AEsgScene_S6 : public AEsgScene
{
	GENERATED_BODY()

public:
	AEsgScene_S6();

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Car1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgBody Car1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> TrashBin1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgBody TrashBin1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Table1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgBody Table1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Wall1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgBody Wall1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Lane1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgBody Lane1Settings;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgHoldVelocity Car1Drive1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgApplyImpulse Table1Impulse1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgSetVelocity Table1Launch1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgAdjustProperties Car1Change1;

protected:
	virtual void CollectBodies() override;
	virtual void CollectProgram() override;
	virtual void DispatchProgram(double Due) override;
};
